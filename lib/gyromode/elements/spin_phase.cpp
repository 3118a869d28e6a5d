#include "gyromode/elements/spin_phase.h"

#include "gyromode/lapack/symmetric.h"

#include <vector>

namespace gyromode {

namespace {

std::vector<Index> all_but(Index n, Index one) {
  std::vector<Index> rest;
  for (Index i = 0; i < n; ++i) {
    if (i != one) rest.push_back(i);
  }
  return rest;
}

System reduced(const System& s, const std::vector<Index>& rest, double m33, const Vector& m3, const Vector& g3) {
  const Matrix m = s.mass()(rest, rest) - m3 * m3.transpose() / m33;
  const Matrix g = s.gyroscopic()(rest, rest) - (m3 * g3.transpose() - g3 * m3.transpose()) / m33;
  const Matrix k = s.stiffness()(rest, rest) + g3 * g3.transpose() / m33;
  Labels labels;
  for (const Index i : rest) labels.push_back(s.labels()[static_cast<std::size_t>(i)]);
  return System(symmetric_part(m), skew_part(g), symmetric_part(k), std::move(labels));
}

}  // namespace

WithoutSpinPhase::WithoutSpinPhase(const System& whole, Index cyclic)
    : cyclic_(cyclic),
      m33_(whole.mass()(cyclic, cyclic)),
      m3_(whole.mass()(all_but(whole.size(), cyclic), cyclic)),
      g3_(whole.gyroscopic().transpose()(all_but(whole.size(), cyclic), cyclic)),
      system_(reduced(whole, all_but(whole.size(), cyclic), m33_, m3_, g3_)) {}

// m₃₃ jω θ₃ = −(jω m₃ + g₃)ᵀ q.
ComplexVector WithoutSpinPhase::restored(const ComplexVector& shape, double omega) const {
  ComplexVector whole(shape.size() + 1);
  whole.head(cyclic_) = shape.head(cyclic_);
  whole.tail(shape.size() - cyclic_) = shape.tail(shape.size() - cyclic_);
  const Complex momentum = m3_.cast<Complex>().dot(shape) + g3_.cast<Complex>().dot(shape) / Complex(0, omega);
  whole(cyclic_) = -momentum / m33_;
  return whole;
}

System low_modes(const System& system, double limit) {
  const auto rest = lapack::symmetric_definite_eigen(system.stiffness(), system.mass());
  std::vector<Index> kept;
  for (Index i = 0; i < system.size(); ++i) {
    if (std::abs(rest.values(i)) <= limit * limit) kept.push_back(i);
  }
  const Matrix v = rest.vectors(Eigen::all, kept);
  const Index n = v.cols();
  const Matrix g = v.transpose() * system.gyroscopic() * v;
  return System(Matrix::Identity(n, n), skew_part(g), Vector(rest.values(kept)).asDiagonal());
}

}  // namespace gyromode
