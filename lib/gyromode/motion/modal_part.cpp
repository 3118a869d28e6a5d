#include "gyromode/motion/modal_part.h"

#include "gyromode/motion/frequency_error.h"

#include <cmath>

namespace gyromode {

namespace {

// |Xᴴ(2ωM − jG)X| over 2ωXᴴMX + |XᴴGX|: 0 at a double root of opposite energies, where rounding leaves √ε.
double distinctness(const ComplexVector& x, double omega, const ComponentMatrices& m) {
  const double inertia = 2 * omega * x.dot(m.mass.cast<Complex>() * x).real();
  const double gyroscopic = x.dot(m.gyroscopic.cast<Complex>() * x).imag();
  return std::abs(inertia + gyroscopic) / (inertia + std::abs(gyroscopic));
}

}  // namespace

ComponentMatrices::ComponentMatrices(const System& system, const std::vector<Index>& order)
    : mass(system.mass()(order, order)), gyroscopic(system.gyroscopic()(order, order)), stiffness(system.stiffness()(order, order)) {}

ModalPart::ModalPart(const ComponentMatrices& m, const SolvedComponent& c) {
  constexpr double simple = 1e-3;  // an error of ε in X becomes ε/κ² in the amplitudes of a pair with this κ
  std::vector<Index> kept;
  const bool definite = c.spectrum.stiffness_negative == 0;
  for (Index k = 0; k < c.spectrum.omega.size(); ++k) {
    const bool decided = c.verdict.energy_sign[static_cast<std::size_t>(k)] != 0;
    if (definite || (decided && distinctness(c.spectrum.shape(k), c.spectrum.omega(k), m) > simple)) kept.push_back(k);
  }
  omega_ = c.spectrum.omega(kept);
  shapes_.resize(m.mass.rows(), omega_.size());
  for (std::size_t k = 0; k < kept.size(); ++k) shapes_.col(static_cast<Index>(k)) = c.spectrum.shape(kept[k]).normalized();
  form_.resize(omega_.size());
  const ComplexMatrix mx = m.mass.cast<Complex>() * shapes_, gx = m.gyroscopic.cast<Complex>() * shapes_;
  for (Index k = 0; k < size(); ++k) form_(k) = 2 * omega_(k) * shapes_.col(k).dot(mx.col(k)).real() + shapes_.col(k).dot(gx.col(k)).imag();
  error_ = frequency_errors(m, shapes_, omega_, form_, c.assessment.error_bound(kept));
}

ComplexVector ModalPart::amplitudes(const ComponentMatrices& m, const State& w) const {
  const Vector mq = m.mass * w.q;
  const Vector momentum = m.mass * w.qdot + m.gyroscopic * w.q;
  const ComplexVector on_q = shapes_.adjoint() * mq.cast<Complex>(), on_momentum = shapes_.adjoint() * momentum.cast<Complex>();
  return (omega_.array() * on_q.array() - Complex(0, 1) * on_momentum.array()) / form_.array();
}

State ModalPart::state(const ComplexVector& a) const {
  const ComplexVector rate = Complex(0, 1) * omega_.array() * a.array();
  return {2 * (shapes_ * a).real(), 2 * (shapes_ * rate).real()};
}

}  // namespace gyromode
