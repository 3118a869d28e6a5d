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

// a = (ωXᴴMq − jXᴴ(p + Gq))/form; of the mirror image X̄, −ω the form has the other sign. XᴴG = −(GX)ᴴ.
ComplexVector WindowedPart::amplitudes(const ComplexVector& q, const ComplexVector& momentum, bool mirrored) const {
  const auto on = [&](const ComplexMatrix& a, const ComplexVector& v) {
    return mirrored ? ComplexVector(a.transpose() * v) : ComplexVector(a.adjoint() * v);
  };
  const Complex j(0, mirrored ? -1 : 1);
  const ComplexVector turned = on(shapes_, momentum) - on(gyroscopic_times_, q);
  return (omega_.array() * on(mass_times_, q).array() - j * turned.array()) / form_.array();
}

double WindowedPart::size_of(const ComplexVector& a) const {
  return std::sqrt((omega_.array() * form_.array().abs() * a.array().abs2()).sum());
}

State WindowedPart::state(const ComplexVector& a) const {
  const ComplexVector rate = Complex(0, 1) * omega_.array() * a.array();
  return {2 * (shapes_ * a).real(), 2 * (shapes_ * rate).real()};
}

Vector WindowedPart::momentum(const ComplexVector& a) const {
  return 2 * (mass_times_ * ComplexVector(Complex(0, 1) * omega_.array() * a.array())).real();
}

// Repeated on what it leaves, as ComponentMotion does: shapes are orthogonal to their errors only.
WindowedPart::Share WindowedPart::share_of(const Vector& q, const Vector& given) const {
  constexpr int passes = 4;
  Share s{ComplexVector::Zero(size()), 0, 0};
  Vector left = q, left_momentum = given;
  for (int pass = 0; pass < passes; ++pass) {
    const ComplexVector more = amplitudes(left.cast<Complex>(), left_momentum.cast<Complex>(), false);
    const double found = size_of(more);
    if (pass > 0 && !(found < 0.5 * s.missing)) break;
    s.missing = found;
    s.amplitudes += more;
    left -= 2 * (shapes_ * more).real();
    left_momentum -= momentum(more);
  }
  s.missing = size_of(amplitudes(left.cast<Complex>(), left_momentum.cast<Complex>(), false));
  s.size = size_of(s.amplitudes);
  return s;
}

// Of the state (0, M⁻¹f) that the force pushes (q̃, ṽ) is left beside the modes: the right side is Mṽ + Gq̃ + jνMq̃.
ComplexVector WindowedPart::beyond(const Vector& force, const ComplexVector& h, double nu) const {
  const Vector mq = -2 * (mass_times_ * h).real(), gq = -2 * (gyroscopic_times_ * h).real();
  return joined(force - momentum(h) + gq, nu * mq);
}

// Its momentum is jνMq − Mq̃, q̃ = −2 Re Xh.
ComplexVector WindowedPart::without_modes(const ComplexVector& q, const ComplexVector& h, double nu) const {
  const Matrix mass = sparse::symmetric_times(system_.mass(), sparse::parts_of(q));
  const ComplexVector p = Complex(0, nu) * joined(mass.col(0), mass.col(1)) + (2 * (mass_times_ * h).real()).cast<Complex>();
  return q - shapes_ * amplitudes(q, p, false) - shapes_.conjugate() * amplitudes(q, p, true);
}

}  // namespace gyromode
