#include "gyromode/motion/driven_runs.h"

#include "gyromode/base/rounding.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// To the nearest pole that is not of the run [first, last]; the mirror image, and poles at zero, are at least as far
// away as zero is.
double gap(const std::vector<PoleMet>& poles, std::size_t first, std::size_t last) {
  double gap = poles[first].at;
  if (first > 0) gap = std::min(gap, poles[first].at - poles[first - 1].at);
  if (last + 1 < poles.size()) gap = std::min(gap, poles[last + 1].at - poles[last].at);
  return gap;
}

}  // namespace

Driven judged(bool met, double participation, double resolution) {
  return !met ? Driven::no : participation > resolution ? Driven::yes : Driven::undecided;
}

// An error δ of the bounds turns a shape towards that of a pole at the distance `gap` by δ/gap, to first order; ten
// times, as energies and lengths of the two differ.
std::vector<DrivenMode> judged(const std::vector<PoleMet>& poles, const ForceSize& f) {
  std::vector<DrivenMode> all;
  for (std::size_t first = 0; first < poles.size();) {
    std::size_t last = first;
    while (last + 1 < poles.size() && poles[last + 1].at - poles[last].at <= poles[last].error + poles[last + 1].error) ++last;
    double work2 = 0, worst = 0;
    bool met = false;
    for (std::size_t k = first; k <= last; ++k) {
      work2 += poles[k].work2;
      met = met || poles[k].met;
      worst = std::max(worst, poles[k].error);
    }
    const double participation = f.whole > 0 ? std::min(1.0, std::sqrt(work2) / f.whole) : 0;
    const double own = f.whole > 0 ? f.own / f.whole : 0;
    const double resolution = own * std::min(1.0, 10 * (static_cast<double>(f.size) * epsilon + worst / gap(poles, first, last)));
    for (std::size_t k = first; k <= last; ++k)
      all.push_back({poles[k].at, poles[k].error, participation, resolution, judged(met, participation, resolution)});
    first = last + 1;
  }
  return all;
}

}  // namespace gyromode
