#include "gyromode/sweep/pencil.h"

#include "gyromode/base/error.h"
#include "gyromode/dense/inertia.h"
#include "gyromode/lapack/general.h"
#include "gyromode/lapack/hermitian.h"
#include "gyromode/lapack/indefinite.h"
#include "gyromode/lapack/small.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/structure/inertia_of_k.h"
#include "gyromode/system/scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// μ and vectors of B v = μ K v, K positive definite.
struct Definite {
  Vector mu;
  ComplexMatrix vectors;
};

Definite definite_eigen(const Matrix& k, const Matrix& re, const Matrix& im) {
  if (im.size() == 0) {
    const auto e = lapack::symmetric_definite_eigen(re, k);
    return {e.values, e.vectors.cast<Complex>()};
  }
  const Matrix l = lapack::Cholesky(k).lower();
  const ComplexMatrix b = re.cast<Complex>() + imaginary_unit * im.cast<Complex>();
  const auto lower = l.triangularView<Eigen::Lower>();
  ComplexMatrix c = lower.solve(b.real().eval()).cast<Complex>() + imaginary_unit * lower.solve(b.imag().eval()).cast<Complex>();
  c = c.adjoint().eval();
  c = lower.solve(c.real().eval()).cast<Complex>() + imaginary_unit * lower.solve(c.imag().eval()).cast<Complex>();
  const auto e = lapack::hermitian_eigen(ComplexMatrix(0.5 * (c + c.adjoint())));
  const auto upper = l.transpose().triangularView<Eigen::Upper>();
  const ComplexMatrix x =
      upper.solve(e.vectors.real().eval()).cast<Complex>() + imaginary_unit * upper.solve(e.vectors.imag().eval()).cast<Complex>();
  return {e.values, x};
}

// Roots at infinity have no μ: what is that small beside the largest is rounding.
bool at_infinity(double mu, double largest, Index n) { return std::abs(mu) <= 8 * static_cast<double>(n) * epsilon * epsilon * largest; }

}  // namespace

// (T13) with the rows and columns of T = diag(1, −j): entries between the groups are ∓mG₁.
SpeedPencil::SpeedPencil(const SpinFamily& f, double m, const std::vector<Index>& coordinates, const std::vector<Index>& in_quadrature,
                         bool partition)
    : coordinates_(coordinates), axes_(coordinates, partition ? in_quadrature : std::vector<Index>{}), real_(partition) {
  const auto part = [&](const Matrix& a) -> Matrix {
    return a.size() > 0 ? Matrix(a(coordinates, coordinates))
                        : Matrix::Zero(static_cast<Index>(coordinates.size()), static_cast<Index>(coordinates.size()));
  };
  stiffness_ = part(f.stiffness);
  re_ = m * m * part(f.mass) - part(f.stiffness_per_spin2);
  const Matrix g = -m * part(f.gyroscopic_per_spin);  // B = re + j g
  if (!real_) {
    im_ = g;
    return;
  }
  re_ += axes_.crossed(g);
}

std::vector<SpeedPencil::Root> SpeedPencil::roots() const {
  const Vector d = equilibrating_scale(stiffness_);
  const Matrix k = scaled(stiffness_, d), re = scaled(re_, d), im = im_.size() > 0 ? scaled(im_, d) : Matrix();
  const StiffnessInertia inertia = inertia_of_k(k);
  const Index n = k.rows();
  std::vector<Root> all;
  const auto add = [&](Complex nu, const ComplexVector& x) {
    ComplexVector own = x.cwiseProduct(d.cast<Complex>());
    all.push_back({nu, axes_.given(own / own.norm())});
  };
  if (inertia.negative == 0) {
    // Z spans the null space of K₀, W the rest: there B' = B_ww − B_wzB_zz⁻¹B_zw.
    const Matrix& z = inertia.null_space;
    const Index zeros = z.cols();
    const Matrix basis = zeros > 0 ? small::orthogonal_factor(z) : Matrix::Identity(n, n);
    const Matrix w = basis.rightCols(n - zeros);
    ComplexMatrix b = re.cast<Complex>();
    if (im.size() > 0) b += imaginary_unit * im.cast<Complex>();
    ComplexMatrix of_w = w.transpose() * b * w, follow = ComplexMatrix::Zero(zeros, n - zeros);
    if (zeros > 0) {
      const ComplexMatrix zz = z.transpose() * b * z, zw = z.transpose() * b * w;
      if (small::singular_values(zz).minCoeff() <= 1e-12 * b.norm())
        throw NotApplicable(
            "the rigid-body motions of the model have no inertia against this order: critical speeds are not determined by the pencil");
      follow = -small::solve(zz, zw);
      of_w += zw.adjoint() * follow;
    }
    const Matrix k_w = w.transpose() * k * w;
    const Definite e = definite_eigen(0.5 * (k_w + k_w.transpose()), of_w.real(), im.size() > 0 ? Matrix(of_w.imag()) : Matrix());
    const double largest = e.mu.size() > 0 ? e.mu.cwiseAbs().maxCoeff() : 0;
    for (Index i = 0; i < e.mu.size(); ++i) {
      if (at_infinity(e.mu(i), largest, n)) continue;
      ComplexVector x = w * e.vectors.col(i);
      if (zeros > 0) x += z * (follow * e.vectors.col(i));
      add(1 / e.mu(i), x);
    }
    return all;
  }
  const auto factor = lapack::factor_indefinite(k);
  lapack::GeneralEigen e;
  if (im.size() == 0) {
    e = lapack::general_eigen(lapack::solve(factor, re));
  } else {
    const ComplexMatrix c = lapack::solve(factor, re).cast<Complex>() + imaginary_unit * lapack::solve(factor, im).cast<Complex>();
    e = lapack::general_eigen(c);
  }
  const double largest = e.values.cwiseAbs().maxCoeff();
  for (Index i = 0; i < n; ++i) {
    if (!at_infinity(std::abs(e.values(i)), largest, n)) add(1.0 / e.values(i), e.vectors.col(i));
  }
  return all;
}

Inertia SpeedPencil::inertia_at(double nu) const {
  if (real_) return inertia(Matrix(stiffness_ - nu * re_));
  return inertia(ComplexMatrix((stiffness_ - nu * re_).cast<Complex>() - (nu * imaginary_unit) * im_.cast<Complex>()));
}

Index SpeedPencil::negative_at_zero() const {
  const StiffnessInertia k = inertia_of_k(stiffness_);
  if (k.zero == 0) return k.negative;
  const Matrix& z = k.null_space;
  ComplexMatrix b = (z.transpose() * re_ * z).cast<Complex>();
  if (!real_) b += imaginary_unit * (z.transpose() * im_ * z).cast<Complex>();
  return k.negative + static_cast<Index>((small::hermitian_eigenvalues(b).array() > 0).count());  // −νB there
}

ComplexVector SpeedPencil::times(double nu, const ComplexVector& own) const {
  ComplexVector product = (stiffness_ - nu * re_) * own;
  if (!real_) product -= (nu * imaginary_unit) * (im_ * own);
  return product;
}

SpeedPencil::Root SpeedPencil::polished(const Root& root) const {
  ComplexVector x = axes_.own(root.shape);
  double nu = root.nu.real();
  const auto quotient = [&] {
    const double bottom = std::real(x.dot(re_ * x)) + (real_ ? 0 : std::real(x.dot(imaginary_unit * (im_ * x))));
    const double top = std::real(x.dot(stiffness_ * x));
    return bottom != 0 ? top / bottom : nu;
  };
  nu = quotient();
  for (int step = 0; step < 2 && !(residual({nu, axes_.given(x)}) <= rounding_unit(x.size())); ++step) {
    ComplexVector b = re_ * x;
    if (!real_) b += imaginary_unit * (im_ * x);
    ComplexVector next;
    if (real_) {
      const auto factor = lapack::factor_indefinite(Matrix(stiffness_ - nu * re_));
      Matrix parts(b.size(), 2);
      parts << b.real(), b.imag();
      parts = lapack::solve(factor, parts);
      next = parts.col(0).cast<Complex>() + imaginary_unit * parts.col(1).cast<Complex>();
    } else {
      next = lapack::solve(
          lapack::factor_indefinite(ComplexMatrix((stiffness_ - nu * re_).cast<Complex>() - (nu * imaginary_unit) * im_.cast<Complex>())),
          ComplexMatrix(b));
    }
    if (!next.allFinite() || !(next.norm() > 0)) break;  // at the root to the last bit
    const ComplexVector before = x;
    const double nu_before = nu;
    x = next / next.norm();
    nu = quotient();
    if (!(times(nu, x).norm() <= times(nu_before, before).norm())) {
      x = before;
      nu = nu_before;
      break;
    }
  }
  return {nu, axes_.given(x)};
}

double SpeedPencil::residual(const Root& root) const {
  const ComplexVector x = axes_.own(root.shape);
  const double nu = root.nu.real();
  const auto norm = [](const Matrix& a) { return a.size() > 0 ? a.cwiseAbs().colwise().sum().maxCoeff() : 0.0; };
  return times(nu, x).norm() / ((norm(stiffness_) + std::abs(nu) * (norm(re_) + norm(im_))) * x.norm());
}

// The residual as it is, and a rounding of every entry, on |X|.
double SpeedPencil::uncertainty(double nu, const ComplexVector& x) const {
  const Vector size = x.cwiseAbs();
  Matrix terms = re_.cwiseAbs();
  if (!real_) terms += im_.cwiseAbs();
  const double rounding = backward_error(size.size()) * size.dot((stiffness_.cwiseAbs() + std::abs(nu) * terms) * size);
  return times(nu, x).norm() * x.norm() + rounding;
}

// To first order, over |xᴴBx|.
double SpeedPencil::error_of(const Root& root) const {
  const ComplexVector x = axes_.own(root.shape);
  double form = std::real(x.dot(re_ * x));
  if (!real_) form += std::real(x.dot(imaginary_unit * (im_ * x)));
  return uncertainty(root.nu.real(), x) / std::abs(form);
}

// Of μ = 1/ν, μK₀x = Bx.
double SpeedPencil::error_of_inverse(const Root& root) const {
  const ComplexVector x = axes_.own(root.shape);
  return uncertainty(root.nu.real(), x) / (std::abs(root.nu.real()) * std::abs(std::real(x.dot(stiffness_ * x))));
}

bool SpeedPencil::is_at_infinity(const Root& root) const { return error_of_inverse(root) >= 0.5 / std::abs(root.nu.real()); }

double SpeedPencil::least_speed(const Root& root) const { return 1 / std::sqrt(1 / std::abs(root.nu.real()) + error_of_inverse(root)); }

}  // namespace gyromode
