#include "gyromode/dense/impedance.h"

#include "gyromode/dense/solve.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/small.h"
#include "gyromode/structure/ranked_factor.h"
#include "gyromode/system/laws.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <cmath>

namespace gyromode::dense {

Impedance::Impedance(const System& system, const Spectrum& s) : Impedance(s.order, s.split, true) {
  take(system.mass(), system.gyroscopic(), &system.stiffness(), false);
}

Impedance::Impedance(const FirstOrderSystem& system, const Spectrum& s) : Impedance(s.order, s.split, false) {
  take(system.inertia(), system.gyroscopic(), nullptr, false);
}

Impedance Impedance::natural(const System& system, std::vector<Index> order, Index split) {
  Impedance h(std::move(order), split, true);
  h.take(system.mass(), system.gyroscopic(), &system.stiffness(), true);
  return h;
}

Impedance Impedance::natural(const FirstOrderSystem& system, std::vector<Index> order, Index split) {
  Impedance h(std::move(order), split, false);
  h.take(system.inertia(), system.gyroscopic(), nullptr, true);
  return h;
}

void Impedance::take(const Matrix& mass, const Matrix& gyroscopic, const Matrix* stiffness, bool natural) {
  const std::vector<Index> real(order_.begin(), split_ < 0 ? order_.end() : order_.begin() + split_);
  const std::vector<Index> imaginary = split_ < 0 ? real : std::vector<Index>(order_.begin() + split_, order_.end());
  m_rr_ = restricted(mass, real, real);
  g_ri_ = restricted(gyroscopic, real, imaginary);
  k_rr_ = stiffness ? restricted(*stiffness, real, real) : Matrix::Zero(m_rr_.rows(), m_rr_.rows());
  if (split_ >= 0) {
    m_ii_ = restricted(mass, imaginary, imaginary);
    k_ii_ = stiffness ? restricted(*stiffness, imaginary, imaginary) : Matrix::Zero(m_ii_.rows(), m_ii_.rows());
  }
  units_ = Units::given(size());
  if (natural) change_units();
  measure_norms();
}

void Impedance::change_units() {
  Vector diagonal(size());
  diagonal << m_rr_.diagonal(), m_ii_.diagonal();
  units_ = natural_units(diagonal, k_rr_, k_ii_, g_ri_, quadrature());
  const Index p = m_rr_.rows();
  const Vector rows = units_.coordinate.head(p);
  const Vector columns = quadrature() ? Vector(units_.coordinate.tail(size() - p)) : rows;
  const double time = units_.time;
  change_units_of(m_rr_, rows, rows, 1);
  change_units_of(g_ri_, rows, columns, time);
  if (second_order_) change_units_of(k_rr_, rows, rows, time * time);
  if (quadrature()) {
    change_units_of(m_ii_, columns, columns, 1);
    if (second_order_) change_units_of(k_ii_, columns, columns, time * time);
  }
}

void Impedance::measure_norms() {
  norm_m_ = norm1(m_rr_);
  norm_k_ = norm1(k_rr_);
  norm_g_ = norm1(g_ri_);
  if (!quadrature()) return;
  norm_m_ = std::max(norm_m_, norm1(m_ii_));
  norm_k_ = std::max(norm_k_, norm1(k_ii_));
  if (g_ri_.size() > 0) norm_g_ = std::max(norm_g_, g_ri_.cwiseAbs().rowwise().sum().maxCoeff());
}

namespace {

// The 1-norm of D₁⁻¹ A D₂⁻¹.
double norm1_without(const Matrix& a, const Eigen::Ref<const Vector>& rows, const Eigen::Ref<const Vector>& columns) {
  double norm = 0;
  for (Index k = 0; k < a.cols(); ++k) norm = std::max(norm, a.col(k).cwiseAbs().cwiseQuotient(rows).sum() / columns(k));
  return norm;
}

}  // namespace

const Impedance::Sizes& Impedance::sizes() const {
  if (sizes_) return *sizes_;
  Sizes z;
  const Index n = size();
  z.k.resize(n);
  z.m.resize(n);
  z.g.resize(n);
  const Vector& d = units_.coordinate;
  if (quadrature()) {
    const auto first = d.head(split_), second = d.tail(n - split_);
    z.k << own_weights(k_rr_), own_weights(k_ii_);
    z.m << m_rr_.diagonal(), m_ii_.diagonal();
    const auto [rows, columns] = own_weights_of_coupling(g_ri_);
    z.g << rows, columns;
    z.given_k = std::max(norm1_without(k_rr_, first, first), norm1_without(k_ii_, second, second));
    z.given_m = std::max(norm1_without(m_rr_, first, first), norm1_without(m_ii_, second, second));
    z.given_g = std::max(norm1_without(g_ri_, first, second), norm1_without(g_ri_.transpose(), second, first));
  } else {
    z.k = own_weights(k_rr_);
    z.m = m_rr_.diagonal();
    z.g = own_weights(g_ri_);
    z.given_k = norm1_without(k_rr_, d, d);
    z.given_m = norm1_without(m_rr_, d, d);
    z.given_g = norm1_without(g_ri_, d, d);
  }
  z.terms_g = z.g;
  z.terms_m = z.m;
  sizes_ = std::move(z);
  return *sizes_;
}

std::optional<Impedance> Impedance::with_null_coordinates() const {
  const RankedFactor one = ranked_factor(k_rr_), two = ranked_factor(k_ii_);
  if (one.zero() + two.zero() == 0) return std::nullopt;
  const auto basis = [](const RankedFactor& f, Index n) {
    Matrix b = Matrix::Identity(n, n);
    for (std::size_t k = 0; k < f.free.size(); ++k) b.col(f.free[k]) = f.null_space.col(static_cast<Index>(k));
    return b;
  };
  const auto without_rows = [](Matrix k, const RankedFactor& f) {
    for (const Index i : f.free) {
      k.row(i).setZero();
      k.col(i).setZero();
    }
    return k;
  };
  const Index p = k_rr_.rows();
  const Matrix b1 = basis(one, p), b2 = quadrature() ? basis(two, size() - p) : b1;
  Impedance h = *this;
  h.k_rr_ = without_rows(k_rr_, one);
  h.m_rr_ = symmetric_part(b1.transpose() * m_rr_ * b1);
  h.g_ri_ = b1.transpose() * g_ri_ * b2;
  if (quadrature()) {
    h.k_ii_ = without_rows(k_ii_, two);
    h.m_ii_ = symmetric_part(b2.transpose() * m_ii_ * b2);
  } else {
    h.g_ri_ = skew_part(h.g_ri_);
  }
  h.basis_ = Matrix::Identity(size(), size());
  h.basis_.topLeftCorner(p, p) = b1;
  if (quadrature()) h.basis_.bottomRightCorner(size() - p, size() - p) = b2;
  const Sizes given = sizes();
  const Units outer = units_;
  h.sizes_.reset();
  h.change_units();
  h.measure_norms();
  h.sizes();  // in the new coordinates, but for the norms of what was given and the terms of the sums
  const double time = h.units_.time;
  const Vector rows = h.units_.coordinate.head(p), columns = quadrature() ? Vector(h.units_.coordinate.tail(size() - p)) : rows;
  const auto terms_of_sums = [](const Matrix& left, const Matrix& a, const Matrix& right, const Vector& row_units,
                                const Vector& column_units, double rate) {
    Matrix t = left.cwiseAbs().transpose() * entry_scale(a) * right.cwiseAbs();
    change_units_of(t, row_units, column_units, rate);
    return t;
  };
  if (quadrature()) {
    h.sizes_->terms_m << terms_of_sums(b1, m_rr_, b1, rows, rows, 1).diagonal(),
        terms_of_sums(b2, m_ii_, b2, columns, columns, 1).diagonal();
    const auto [of_rows, of_columns] = own_weights_of_coupling(terms_of_sums(b1, g_ri_, b2, rows, columns, time));
    h.sizes_->terms_g << of_rows, of_columns;
  } else {
    h.sizes_->terms_m = terms_of_sums(b1, m_rr_, b1, rows, rows, 1).diagonal();
    h.sizes_->terms_g = own_weights(terms_of_sums(b1, g_ri_, b1, rows, rows, time));
  }
  h.sizes_->given_k = given.given_k * time * time;
  h.sizes_->given_g = given.given_g * time;
  h.sizes_->given_m = given.given_m;
  h.basis_ = (h.basis_ * h.units_.coordinate.asDiagonal()).eval();
  h.units_ = {outer.coordinate, outer.time * time};
  return h;
}

double Impedance::given_residual(const ComplexVector& r, const ComplexVector& x, double omega) const {
  const auto d = units_.coordinate.cast<Complex>();
  if (basis_.size() == 0) return r.cwiseQuotient(d).norm() / (given_scale(omega) * x.cwiseProduct(d).norm());
  const ComplexVector image = small::solve(ComplexMatrix(basis_.transpose().cast<Complex>()), r);
  return image.cwiseQuotient(d).norm() / (given_scale(omega) * (basis_ * x).cwiseProduct(d).norm());
}

void Impedance::to_given(Spectrum& s) const {
  if (basis_.size() > 0) {
    const Index p = split_ < 0 ? size() : split_;
    const Index r = size() - p;
    s.re = (basis_.topLeftCorner(p, p) * s.re).eval();
    s.im = split_ < 0 ? Matrix(basis_ * s.im) : Matrix(basis_.bottomRightCorner(r, r) * s.im);
    s.zero_shapes = (basis_ * s.zero_shapes).eval();
    if (s.unstable.count() > 0) {
      s.unstable.right = (basis_ * s.unstable.right).eval();
      s.unstable.left = (basis_ * s.unstable.left).eval();
    }
  }
  s.to_given_units(units_);
}

Matrix Impedance::own_shapes(const Matrix& given) const {
  const Matrix shapes = units_.coordinate.cwiseInverse().asDiagonal() * given;
  return basis_.size() == 0 ? shapes : Matrix(small::solve(basis_, shapes));
}

double Impedance::typical_frequency() const { return std::max(std::sqrt(norm_k_ / norm_m_), norm_g_ / norm_m_) / units_.time; }

double Impedance::scale(double omega) const {
  return second_order_ ? norm_k_ + omega * (norm_g_ + omega * norm_m_) : omega * norm_m_ + norm_g_;
}
double Impedance::given_scale(double omega) const {
  const Sizes& z = sizes();
  return second_order_ ? z.given_k + omega * (z.given_g + omega * z.given_m) : omega * z.given_m + z.given_g;
}

Vector Impedance::weight(double omega) const {
  const Sizes& z = sizes();
  return second_order_ ? Vector(z.k + omega * (z.g + omega * z.m)) : Vector(z.g + omega * z.m);
}

Vector Impedance::rounding_weight(double omega) const {
  const Sizes& z = sizes();
  return second_order_ ? Vector(z.k + omega * (z.terms_g + omega * z.terms_m)) : Vector(z.terms_g + omega * z.terms_m);
}

// [on_k K₁ + on_m M₁, on_g B; ·, on_k K₂ + on_m M₂]
Matrix Impedance::star(double on_k, double on_m, double on_g) const {
  const Index p = m_rr_.rows();
  const Index n = size();
  Matrix h(n, n);
  h.topLeftCorner(p, p) = on_k * k_rr_ + on_m * m_rr_;
  h.bottomRightCorner(n - p, n - p) = on_k * k_ii_ + on_m * m_ii_;
  h.topRightCorner(p, n - p) = on_g * g_ri_;
  h.bottomLeftCorner(n - p, p) = on_g * g_ri_.transpose();
  return h;
}

// on_k K + on_m M + j on_g G
ComplexMatrix Impedance::hermitian(double on_k, double on_m, double on_g) const {
  ComplexMatrix h(size(), size());
  h.real() = on_k * k_rr_ + on_m * m_rr_;
  h.imag() = on_g * g_ri_;
  return h;
}

// T⁻¹(jωG)T has the blocks ωB and ωBᵀ; T⁻¹(−jG)T has −B and −Bᵀ.
Matrix Impedance::real_at(double omega) const { return second_order_ ? star(1, -omega * omega, omega) : star(0, omega, -1); }
Matrix Impedance::real_slope_at(double omega) const { return second_order_ ? star(0, 2 * omega, -1) : star(0, 1, 0); }
ComplexMatrix Impedance::complex_at(double omega) const {
  return second_order_ ? hermitian(1, -omega * omega, omega) : hermitian(0, omega, -1);
}
ComplexMatrix Impedance::complex_slope_at(double omega) const { return second_order_ ? hermitian(0, 2 * omega, -1) : hermitian(0, 1, 0); }

ComplexMatrix Impedance::combined(Complex on_k, Complex on_g, Complex on_m) const {
  if (!quadrature()) return on_k * k_rr_ + on_g * g_ri_ + on_m * m_rr_;
  const Index r = size() - split_;
  ComplexMatrix a(size(), size());
  a.topLeftCorner(split_, split_) = on_k * k_rr_ + on_m * m_rr_;
  a.bottomRightCorner(r, r) = on_k * k_ii_ + on_m * m_ii_;
  a.topRightCorner(split_, r) = on_g * g_ri_;
  a.bottomLeftCorner(r, split_) = -on_g * g_ri_.transpose();
  return a;
}

ComplexMatrix Impedance::characteristic_at(Complex lambda) const { return combined(1, lambda, lambda * lambda); }
ComplexMatrix Impedance::characteristic_slope_at(Complex lambda) const { return combined(0, 1, 2.0 * lambda); }

RowProducts Impedance::products(const Matrix& re, const Matrix& im) const {
  RowProducts p;
  p.m_re = lapack::multiply(m_rr_, re);
  p.m_im = lapack::multiply(mass_ii(), im);
  p.g_re = Matrix(g_ri_.rows(), im.cols());
  p.g_im = Matrix(g_ri_.cols(), re.cols());
  lapack::multiply_into(p.g_re, -1, g_ri_, false, im, false, 0);
  lapack::multiply_into(p.g_im, -1, g_ri_, true, re, false, 0);
  if (second_order_) {
    p.k_re = lapack::multiply(k_rr_, re);
    p.k_im = lapack::multiply(stiffness_ii(), im);
  }
  return p;
}

ComplexMatrix Impedance::form(const ComplexMatrix& x, double omega) const {
  if (!quadrature()) return x.adjoint() * (complex_slope_at(omega) * x);
  ComplexMatrix star = x;  // X* = T⁻¹X
  star.bottomRows(size() - split_) *= Complex(0, 1);
  return star.adjoint() * (real_slope_at(omega) * star);
}

Index Impedance::half_rank_of_gyroscopic() const {
  return quadrature() ? clearly_negative(star(0, 0, -1)) : clearly_negative(hermitian(0, 0, -1));
}

// Above ω = 1 the impedance over ω² (over ω in first order), which has the same inertia and does not overflow.
Inertia Impedance::inertia_at(double omega) const {
  const bool large = omega > 1;
  const double inverse = 1 / omega;
  const double on_k = !second_order_ ? 0 : large ? inverse * inverse : 1;
  const double on_m = second_order_ ? (large ? -1 : -omega * omega) : (large ? 1 : omega);
  const double on_g = second_order_ ? (large ? inverse : omega) : (large ? -inverse : -1);
  // The terms of every row near 1, by powers of two: what is small beside them is their rounding.
  const Sizes& z = sizes();
  const Vector terms = on_k * z.k + std::abs(on_g) * z.g + std::abs(on_m) * z.m;
  const Vector d = terms.unaryExpr([](double w) { return w > 0 ? power_of_two_near(1 / std::sqrt(w)) : 1; });
  return quadrature() ? inertia_of_sum(scaled(star(on_k, on_m, on_g), d)) : inertia_of_sum(scaled(hermitian(on_k, on_m, on_g), d));
}

}  // namespace gyromode::dense
