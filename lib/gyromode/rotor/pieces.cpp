#include "gyromode/rotor/pieces.h"

#include <algorithm>
#include <vector>

namespace gyromode {

void each_piece(const Rotor& r, const std::function<void(const PieceBetween&)>& see) {
  std::vector<double> ends;
  for (const Spool& s : r.spools()) ends.push_back(s.start);
  for (const ShaftSection& s : r.parts().shafts) {
    const std::size_t spool = r.spool_named(s.spool);
    const double start = ends[spool], end = start + s.length;
    ends[spool] = end;
    const auto section_at = [&](double z) {
      const double t = std::clamp((z - start) / s.length, 0.0, 1.0);
      return CrossSection{(1 - t) * s.outer_diameter[0] + t * s.outer_diameter[1], (1 - t) * s.inner_diameter[0] + t * s.inner_diameter[1]};
    };
    const Station* before = nullptr;
    for (const Station& station : r.stations()) {
      if (station.spool != spool || station.position < start - r.tolerance() || station.position > end + r.tolerance()) continue;
      if (before) {
        see({*before, station, s, r.spools()[spool].speed_ratio,
             ShaftPiece{r.material_named(s.material), station.position - before->position, section_at(before->position),
                        section_at(station.position), s.theory, s.shear_coefficient}});
      }
      before = &station;
    }
  }
}

}  // namespace gyromode
