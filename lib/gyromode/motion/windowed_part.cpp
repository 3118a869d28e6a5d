#include "gyromode/motion/windowed_part.h"

#include "gyromode/sparse/basis.h"
#include "gyromode/sparse/matrix.h"

#include <cmath>

namespace gyromode {

namespace {

ComplexMatrix joined(const Matrix& re, const Matrix& im) {
  ComplexMatrix z(re.rows(), re.cols());
  z.real() = re;
  z.imag() = im;
  return z;
}

}  // namespace

// Of double roots of opposite energies the form vanishes: no amplitudes are known of them.
WindowedPart::WindowedPart(const SparseSystem& system, const ModesResult& found) : system_(system) {
  constexpr double simple = 1e-3;
  const bool definite = found.stiffness.negative == 0;
  for (std::size_t k = 0; k < found.modes.size(); ++k) {
    const Mode& m = found.modes[k];
    if (m.omega > 0 && m.energy_sign != 0) which_.push_back(static_cast<Index>(k));
  }
  const auto number = static_cast<Index>(which_.size());
  Matrix re(system.size(), number), im(system.size(), number);
  omega_.resize(number);
  form_ = error_ = omega_;
  for (Index k = 0; k < number; ++k) {
    const Mode& m = found.modes[static_cast<std::size_t>(which_[static_cast<std::size_t>(k)])];
    re.col(k) = m.shape.real();
    im.col(k) = m.shape.imag();
    omega_(k) = m.omega;
    error_(k) = m.error_bound;
  }
  re = sparse::from_given(system, re);
  im = sparse::from_given(system, im);
  shapes_ = joined(re, im);
  mass_times_ = joined(sparse::symmetric_times(system.mass(), re), sparse::symmetric_times(system.mass(), im));
  gyroscopic_times_ = joined(sparse::skew_times(system.gyroscopic(), re), sparse::skew_times(system.gyroscopic(), im));
  std::vector<Index> kept;
  for (Index k = 0; k < number; ++k) {
    const double inertia = 2 * omega_(k) * shapes_.col(k).dot(mass_times_.col(k)).real();
    const double gyroscopic = shapes_.col(k).dot(gyroscopic_times_.col(k)).imag();
    form_(k) = inertia + gyroscopic;
    if (definite || std::abs(form_(k)) > simple * (inertia + std::abs(gyroscopic))) kept.push_back(k);
  }
  if (static_cast<Index>(kept.size()) == number) return;
  std::vector<Index> which;
  for (const Index k : kept) which.push_back(which_[static_cast<std::size_t>(k)]);
  which_ = which;
  for (Vector* v : {&omega_, &form_, &error_}) *v = Vector((*v)(kept));
  for (ComplexMatrix* a : {&shapes_, &mass_times_, &gyroscopic_times_}) *a = ComplexMatrix((*a)(Eigen::all, kept));
}

// a = (ωXᴴMq − jXᴴ(Mq̇ + Gq))/form; of the mirror image X̄, −ω the form has the other sign. XᴴG = −(GX)ᴴ.
ComplexVector WindowedPart::amplitudes(const ComplexState& w, bool mirrored) const {
  const auto on = [&](const ComplexMatrix& a, const ComplexVector& v) {
    return mirrored ? ComplexVector(a.transpose() * v) : ComplexVector(a.adjoint() * v);
  };
  const Complex j(0, mirrored ? -1 : 1);
  const ComplexVector momentum = on(mass_times_, w.qdot) - on(gyroscopic_times_, w.q);
  return (omega_.array() * on(mass_times_, w.q).array() - j * momentum.array()) / form_.array();
}

ComplexVector WindowedPart::amplitudes(const State& w) const { return amplitudes({w.q.cast<Complex>(), w.qdot.cast<Complex>()}, false); }

ComplexVector WindowedPart::pushed(const Vector& force) const {
  return Complex(0, -1) * (shapes_.adjoint() * force.cast<Complex>()).array() / form_.array();
}

State WindowedPart::state(const ComplexVector& a) const {
  const ComplexVector rate = Complex(0, 1) * omega_.array() * a.array();
  return {2 * (shapes_ * a).real(), 2 * (shapes_ * rate).real()};
}

// Of the state (0, M⁻¹f) that the force pushes (q̃, ṽ) is left beside the modes: the right side is Mṽ + Gq̃ + jνMq̃.
ComplexVector WindowedPart::beyond(const Vector& force, double nu) const {
  const ComplexVector h = pushed(force), rate = Complex(0, 1) * omega_.array() * h.array();
  const Vector mq = -2 * (mass_times_ * h).real(), gq = -2 * (gyroscopic_times_ * h).real(), mv = force - 2 * (mass_times_ * rate).real();
  return joined(mv + gq, nu * mq);
}

ComplexVector WindowedPart::without_modes(const ComplexVector& q, const Vector& force, double nu) const {
  const Vector pushed_by = state(pushed(force)).q;  // −q̃
  const ComplexState w{q, Complex(0, nu) * q + pushed_by.cast<Complex>()};
  return q - shapes_ * amplitudes(w, false) - shapes_.conjugate() * amplitudes(w, true);
}

}  // namespace gyromode
