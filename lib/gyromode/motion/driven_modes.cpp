#include "gyromode/motion/driven_modes.h"

#include "gyromode/motion/driven_runs.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/motion/zero_part.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

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

  void add_all() {
    std::vector<PoleMet> poles;
    for (Index k = 0; k < omega().size(); ++k) {
      const ComplexVector x = solved.spectrum.shape(k);
      poles.push_back({omega()(k), error(k), std::norm(x.dot(force.cast<Complex>())) / x.dot(matrices.mass.cast<Complex>() * x).real(),
                       x.cwiseAbs().dot(force.cwiseAbs()) > 0});
    }
    const std::vector<DrivenMode> found = judged(poles, {size, whole, force.size()});
    to.insert(to.end(), found.begin(), found.end());
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
