#include "gyromode/motion/driven_modes.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/motion/zero_part.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

Driven judged(bool met, double participation, double resolution) {
  return !met ? Driven::no : participation > resolution ? Driven::yes : Driven::undecided;
}

// A run of modes that their errors let coincide, [first, last]: their span is what is determined.
struct Run {
  Index first, last;
};

struct DrivenComponent {
  const SolvedComponent& solved;
  ComponentMatrices matrices;
  Vector force;
  double size, whole;  // √(fᵀM⁻¹f) of the force on this component, and on all
  std::vector<DrivenMode>& to;

  const Vector& omega() const { return solved.spectrum.omega; }

  double error(Index k) const {
    constexpr double widest = 1e-7;  // near a defective pair bounds say nothing, and the response is finite but there
    return std::min(solved.assessment.error_bound(k) + 4 * epsilon * omega()(k), widest * omega()(k));
  }

  Run run_from(Index first) const {
    Index last = first;
    while (last + 1 < omega().size() && omega()(last + 1) - omega()(last) <= error(last) + error(last + 1)) ++last;
    return {first, last};
  }

  // To the nearest root that is not of the run; the mirror image −ω and zero roots are at least ω away.
  double gap(const Run& r) const {
    double gap = omega()(r.first);
    if (r.first > 0) gap = std::min(gap, omega()(r.first) - omega()(r.first - 1));
    if (r.last + 1 < omega().size()) gap = std::min(gap, omega()(r.last + 1) - omega()(r.last));
    return gap;
  }

  // An error δω of the bounds turns a shape towards that of a root at the distance `gap` by δω/gap, to first order; ten
  // times, as energies and lengths of the two differ.
  void add_run(const Run& r) {
    double work2 = 0, worst = 0;
    bool met = false;
    for (Index k = r.first; k <= r.last; ++k) {
      const ComplexVector x = solved.spectrum.shape(k);
      work2 += std::norm(x.dot(force.cast<Complex>())) / x.dot(matrices.mass.cast<Complex>() * x).real();
      met = met || x.cwiseAbs().dot(force.cwiseAbs()) > 0;
      worst = std::max(worst, error(k));
    }
    const double participation = whole > 0 ? std::min(1.0, std::sqrt(work2) / whole) : 0;
    const double own = whole > 0 ? size / whole : 0;
    const double resolution = own * std::min(1.0, 10 * (static_cast<double>(force.size()) * epsilon + worst / gap(r)));
    for (Index k = r.first; k <= r.last; ++k)
      to.push_back({omega()(k), error(k), participation, resolution, judged(met, participation, resolution)});
  }

  // Places and drifts that the force excites: the response at rest is unbounded. What is excited is compared with the
  // terms that add up to it.
  DrivenMode at_rest() const {
    constexpr double resolution = 1e-10;
    const ZeroPart zero(matrices, solved.spectrum.zero_pairs());
    const bool met = size > 0;
    if (!zero.complete()) return {0, 0, met ? 1.0 : 0.0, resolution, judged(met, 1, resolution)};
    const Vector excited = zero.excitation(force), most = zero.largest_excitation(force);
    double largest = 0;
    for (Index i = 0; i < excited.size(); ++i) {
      if (most(i) > 0) largest = std::max(largest, std::abs(excited(i)) / most(i));
    }
    return {0, 0, largest, resolution, judged(most.size() > 0 && most.maxCoeff() > 0, largest, resolution)};
  }

  void add_all() {
    for (Index first = 0; first < omega().size();) {
      const Run r = run_from(first);
      add_run(r);
      first = r.last + 1;
    }
  }
};

}  // namespace

std::string_view to_string(Driven d) {
  switch (d) {
    case Driven::no: return "no";
    case Driven::undecided: return "undecided";
    default: return "yes";
  }
}

std::vector<DrivenMode> driven_modes(const SolvedSystem& solved, const UnitMasses& units, const Vector& given) {
  const double largest = given.size() > 0 ? given.cwiseAbs().maxCoeff() : 0;
  const Vector force = given / power_of_two_near(largest);  // its size does not matter; squares of it are taken
  const auto size = [](Vector f, const Matrix& mass) {      // √(fᵀM⁻¹f)
    lapack::solve_lower(lapack::Cholesky(mass).lower(), f);
    return f.norm();
  };
  const double whole = size(force, units.system.mass());
  std::vector<DrivenMode> all;
  std::optional<DrivenMode> rest;
  for (const SolvedComponent& c : solved.components) {
    const Vector own = force(c.spectrum.order);
    const ComponentMatrices matrices(units.system, c.spectrum.order);
    DrivenComponent one{c, matrices, own, size(own, matrices.mass), whole, all};
    one.add_all();
    if (c.spectrum.zero_pairs() == 0) continue;
    const DrivenMode zero = one.at_rest();
    if (!rest || zero.driven > rest->driven || (zero.driven == rest->driven && zero.participation > rest->participation)) rest = zero;
  }
  if (rest) all.push_back(*rest);
  std::stable_sort(all.begin(), all.end(), [](const DrivenMode& a, const DrivenMode& b) { return a.omega < b.omega; });
  return all;
}

}  // namespace gyromode
