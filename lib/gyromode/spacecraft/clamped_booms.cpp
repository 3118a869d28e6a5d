#include "gyromode/spacecraft/clamped_booms.h"

#include "gyromode/base/rounding.h"
#include "gyromode/roots/converge.h"
#include "gyromode/appendage/cable.h"
#include "gyromode/appendage/beam.h"
#include "gyromode/appendage/spring_mass.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode {

namespace {

// One appendage on a body at rest in turning axes: its own rows and columns alone.
class ClampedImpedance : public LiftedImpedance {
 public:
  ClampedImpedance(const Appendage& appendage, double spin) : appendage_(appendage), spin_(spin) {}

  Index size() const override { return appendage_.coordinates(); }
  Couplings couplings() const override {
    Couplings whole(body_coordinates + size()), own(size());
    appendage_.couple(whole, body_coordinates);
    for (Index i = 0; i < size(); ++i) {
      for (const auto& [to, kind] : whole.graph().neighbours[static_cast<std::size_t>(body_coordinates + i)]) {
        if (to >= body_coordinates) own.add(i, to - body_coordinates, kind);
      }
    }
    return own;
  }
  Lifted at(double omega) const override {
    Lifted whole = zero();
    appendage_.add(omega, whole, body_coordinates);
    return {whole.matrix.bottomRightCorner(size(), size()), {whole.poles_below.begin() + body_coordinates, whole.poles_below.end()}};
  }
  ComplexMatrix at(Complex omega) const override {
    Lifted whole = zero();
    appendage_.add(omega, whole, body_coordinates);
    return whole.matrix.bottomRightCorner(size(), size());
  }
  double rounding(double omega) const override { return epsilon * (static_cast<double>(size()) + 2 * omega / spin_); }

 private:
  Lifted zero() const {
    const Index n = body_coordinates + size();
    return {ComplexMatrix::Zero(n, n), std::vector<Index>(static_cast<std::size_t>(n), 0)};
  }

  const Appendage& appendage_;
  double spin_;
};

// Roots of the blocks that hold coordinate `of`.
std::vector<double> lowest(const Appendage& appendage, double spin, Index of, Index count) {
  const ClampedImpedance clamped(appendage, spin);
  const BlockedImpedance blocked(clamped);
  const MonotoneCount as_counted = [](Index, double, Index n) { return n; };
  std::vector<double> found;
  constexpr double highest = 1e4;  // spins: a rigid direction has no more
  for (double top = 4 * spin; top < highest * spin && static_cast<Index>(found.size()) < count; top *= 4) {
    found.clear();
    isolate(blocked, 0, top, as_counted, [&](const Bracket& b) {
      const auto& c = blocked.blocks[static_cast<std::size_t>(b.block)].coordinates;
      if (std::find(c.begin(), c.end(), of) != c.end()) found.push_back(converge(blocked, b).front().omega);
      return true;
    });
  }
  std::sort(found.begin(), found.end());
  found.resize(std::min(found.size(), static_cast<std::size_t>(count)));
  return found;
}

std::string numbered(const char* one, const std::vector<std::size_t>& which) {
  return fmt::format("{}{} {}", one, which.size() > 1 ? "s" : "", fmt::join(which, ", "));
}

}  // namespace

std::vector<ClampedBoom> clamped_booms(const Spacecraft& s, Index count) {
  std::vector<ClampedBoom> all;
  for (std::size_t i = 0; i < s.cables().size(); ++i) {
    std::vector<std::size_t> equal;
    bool first = true;
    for (std::size_t k = 0; k < s.cables().size(); ++k) {
      if (!s.cables()[k].same_field(s.cables()[i])) continue;
      first = first && k >= i;
      equal.push_back(k + 1);
    }
    if (!first) continue;
    const CableGroup one({s.cables()[i]}, s.spin());
    all.push_back({numbered("cable", equal) + ", in plane", lowest(one, s.spin(), 0, count)});
    all.push_back({numbered("cable", equal) + ", out of plane", lowest(one, s.spin(), 1, count)});
  }
  for (std::size_t i = 0; i < s.beams().size(); ++i) {
    const BeamAppendage beam(s.beams()[i], s.spin());
    std::vector<double> both = lowest(beam, s.spin(), 0, count);
    const std::vector<double> second = lowest(beam, s.spin(), 1, count);
    both.insert(both.end(), second.begin(), second.end());
    std::sort(both.begin(), both.end());
    both.resize(std::min(both.size(), static_cast<std::size_t>(count)));
    all.push_back({fmt::format("beam {}", i + 1), std::move(both)});
  }
  for (std::size_t i = 0; i < s.masses().size(); ++i) {
    const SpringMassAppendage mass(s.masses()[i], s.spin());
    std::vector<double> roots;
    for (Index k = 0; k < mass.coordinates(); ++k) {
      for (const double w : lowest(mass, s.spin(), k, count)) {
        if (std::none_of(roots.begin(), roots.end(), [&](double r) { return r == w; })) roots.push_back(w);
      }
    }
    std::sort(roots.begin(), roots.end());
    if (!roots.empty()) all.push_back({fmt::format("spring mass {}", i + 1), std::move(roots)});
  }
  return all;
}

}  // namespace gyromode
