#include "gyromode/modes/root_vectors.h"

#include "gyromode/lapack/multiply.h"

namespace gyromode {

VectorPlace RootVectors::store(const ComplexVector& x) {
  parts_.col(stored_) = x.real();
  parts_.col(columns() + stored_) = x.imag();
  return {stored_++, false};
}

// N(jω) is Hermitian, so that y = x, and the slope is j times the form. λ, λ̄, −λ̄, −λ off the axis: the left vector of
// one is the right vector of its mirror image in the imaginary axis.
RootVectors::RootVectors(const System& s, const std::vector<Mode>& oscillations, const UnstableRoots& unstable, const Condensation* whole)
    : RootVectors(whole ? static_cast<Index>(whole->labels.size()) : s.size(),
                  static_cast<Index>(oscillations.size()) + 2 * unstable.count(), whole) {
  const Complex j(0, 1);
  for (std::size_t k = 0; k < oscillations.size(); ++k) {
    const Mode& m = oscillations[k];
    const VectorPlace x = store(in_whole(j * m.omega, m.shape));
    roots_.push_back({j * m.omega, j * m.form, x, x, static_cast<Index>(k)});
    roots_.push_back({-j * m.omega, -j * m.form, x.conjugated(), x.conjugated(), -1});
  }
  for (Index k = 0; k < unstable.count(); ++k) {
    const Complex lambda = unstable.lambda[static_cast<std::size_t>(k)];
    const ComplexVector right = unstable.right.col(k), left = unstable.left.col(k);
    const Complex slope = left.dot((2.0 * lambda) * (s.mass() * right) + s.gyroscopic() * right);
    const Complex mirrored = right.dot((-2.0 * std::conj(lambda)) * (s.mass() * left) + s.gyroscopic() * left);
    const VectorPlace x = store(in_whole(lambda, right)), y = store(in_whole(-std::conj(lambda), left));
    roots_.push_back({lambda, slope, x, y, -1});
    roots_.push_back({-std::conj(lambda), mirrored, y, x, -1});
    if (lambda.imag() == 0) continue;
    roots_.push_back({std::conj(lambda), std::conj(slope), x.conjugated(), y.conjugated(), -1});
    roots_.push_back({-lambda, std::conj(mirrored), y.conjugated(), x.conjugated(), -1});
  }
}

RootVectors::RootVectors(const FirstOrderSystem& s, const std::vector<Mode>& oscillations, const Matrix& zero_shapes)
    : RootVectors(s.size(), static_cast<Index>(oscillations.size()) + zero_shapes.cols(), nullptr) {
  const Complex j(0, 1);
  for (std::size_t k = 0; k < oscillations.size(); ++k) {
    const Mode& m = oscillations[k];
    const VectorPlace x = store(m.shape);
    roots_.push_back({j * m.omega, m.form, x, x, static_cast<Index>(k)});
    roots_.push_back({-j * m.omega, m.form, x.conjugated(), x.conjugated(), -1});
  }
  for (Index k = 0; k < zero_shapes.cols(); ++k) {
    const Vector shape = zero_shapes.col(k);
    const VectorPlace x = store(shape.cast<Complex>());
    roots_.push_back({0, shape.dot(s.inertia() * shape), x, x, -1});
  }
}

// The real part of a sum over x_k: its coefficients are found for the real and the imaginary parts of the columns.
Matrix RootVectors::compliance_times(const Matrix& v) const {
  const Matrix seen = lapack::multiply_tn(parts_, v);
  Matrix coefficients = Matrix::Zero(parts_.cols(), v.cols());
  for (const RootPlace& r : roots_) {
    const Complex weight = -1.0 / (r.lambda * r.slope);
    for (Index c = 0; c < v.cols(); ++c) {
      const Complex yv(seen(r.left.column, c), -r.left.sign() * seen(columns() + r.left.column, c));
      const Complex by = weight * yv;
      coefficients(r.right.column, c) += by.real();
      coefficients(columns() + r.right.column, c) -= r.right.sign() * by.imag();
    }
  }
  Matrix product = lapack::multiply(parts_, coefficients);
  if (whole_) product(whole_->massless, Eigen::all) += whole_->compliance_at_infinity * v(whole_->massless, Eigen::all);
  return product;
}

}  // namespace gyromode
