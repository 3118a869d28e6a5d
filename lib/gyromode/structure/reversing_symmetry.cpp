#include "gyromode/structure/reversing_symmetry.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/hermitian.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/status.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/structure/conjugation.h"
#include "gyromode/structure/reflection.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

constexpr double allowance = 4;  // times n: what rounding may do, in units of what one error in the last place does on average

// Mass-normalised coordinates q = D L⁻ᵀ z, and what one unit in the last place of every entry of M, G, K does to k and
// Γ there (Frobenius norms).
struct Normalised {
  Vector scale;
  Matrix l, k, gamma;
  double norm_k = 0, norm_gamma = 0;
  double noise_k = 0, noise_gamma = 0;
};

Vector largest_by_row(const Matrix& a) { return a.cwiseAbs().rowwise().maxCoeff(); }

Normalised normalised(const Matrix& mass, const Matrix& gyroscopic, const Matrix& stiffness) {
  Normalised s;
  s.scale = unit_diagonal_scale(mass);
  s.l = scaled(mass, s.scale);
  if (lapack::cholesky(s.l)) throw NotConverged("the mass matrix is not numerically positive definite");
  const Matrix k = scaled(stiffness, s.scale), g = scaled(gyroscopic, s.scale);
  s.k = lapack::congruence(s.l, k);
  Matrix gamma = g;
  lapack::solve_lower(s.l, gamma);
  lapack::solve_lower_transposed_right(s.l, gamma);
  s.gamma = 0.5 * (gamma - gamma.transpose());
  s.norm_k = s.k.norm();
  s.norm_gamma = s.gamma.norm();
  // Independent errors ε√(r_i r_j), r_i the largest entry of row i, become L⁻¹EL⁻ᵀ of norm ε Σ r_i ‖L⁻¹e_i‖² on
  // average.
  Matrix inverse = Matrix::Identity(mass.rows(), mass.rows());
  lapack::solve_lower(s.l, inverse);
  const Vector stretch = inverse.colwise().squaredNorm().transpose();
  const double noise_mass = epsilon * scaled(mass, s.scale).diagonal().dot(stretch);
  const double n = static_cast<double>(mass.rows());
  s.noise_k = epsilon * largest_by_row(k).dot(stretch) + noise_mass * s.norm_k / std::sqrt(n);
  s.noise_gamma = epsilon * largest_by_row(g).dot(stretch) + noise_mass * s.norm_gamma / std::sqrt(n);
  return s;
}

// Where the strongest couplings do not lead to a symmetry, the space of all solutions is computed for so many unknowns:
// about the order of the system, more with clusters.
constexpr Index affordable_unknowns = 600;

double ratio(double a, double b) { return b > 0 ? a / b : a > 0 ? infinity : 0; }

ComplexMatrix hermitian_combination(const Normalised& s, double unit_k, double unit_gamma) {
  constexpr double alpha = 0.73;  // any number that no symmetry of a model singles out
  ComplexMatrix a(s.k.rows(), s.k.rows());
  a.real() = s.k / unit_k;
  a.imag() = (alpha / unit_gamma) * s.gamma;
  return a;
}

// The best reflection so far. Breaches are measured against what rounding may do: at most 4n times the noise.
class Search {
 public:
  explicit Search(const Normalised& s)
      : s_(s),
        n_(static_cast<double>(s.k.rows())),
        unit_k_(unit(s.norm_k)),
        unit_gamma_(unit(s.norm_gamma)),
        limit_k_(safety * n_ * s.noise_k),
        limit_gamma_(safety * n_ * s.noise_gamma) {}

  double unit_k() const { return unit_k_; }
  double unit_gamma() const { return unit_gamma_; }
  const Reflection& best() const { return *best_; }
  bool found() const { return worst(*best_) <= 1; }
  /// Breaches that are small parts of ‖k‖ and ‖Γ‖.
  bool near_miss() const { return best_->departure_k() <= near * s_.norm_k && best_->departure_gamma() <= near * s_.norm_gamma; }

  void consider(SignedBasis v) { take(Reflection(s_.k, s_.gamma, std::move(v.plus), std::move(v.minus))); }
  /// By small angles, where they can do something: from where it stands, and from where it commutes with k.
  void turn() {
    constexpr double plain = 0.05;  // of what rounding may do: nothing to turn
    if (!(worst(*best_) > plain) || !near_miss()) return;
    const double enough = plain * std::min(limit_k_ / unit_k_, limit_gamma_ / unit_gamma_);
    const SignedBasis commuting = commuting_with(s_.k, *best_, safety * s_.noise_k);
    if (commuting.plus.cols() == best_->plus.cols())
      take(turned(s_.k, s_.gamma, Reflection(s_.k, s_.gamma, commuting.plus, commuting.minus), unit_k_, unit_gamma_, enough));
    if (worst(*best_) > 1) take(turned(s_.k, s_.gamma, *best_, unit_k_, unit_gamma_, enough));
  }
  // Elements of the space of solutions, each a generic one, until one will do: where the space is a line to within
  // `spread`, one is as good as another; where it is not, an unlucky draw can be nearly singular. Where a clear one of
  // a wider spread is no better than those before, none will be.
  void draw(const Conjugation& conjugation, double noise) {
    for (const double spread : {0.3 * noise, 3 * noise, 1e-7, 1e-3}) {
      const double before = worst(*best_);
      bool clear = false;
      for (std::uint64_t seed = 1; seed <= 3 && !clear; ++seed) {
        SignedBasis v = sign_of(conjugation.real_element(spread, seed));
        clear = v.clearness > 0.1;
        consider(std::move(v));
        if (found()) return;
      }
      if (clear && spread > noise && !(worst(*best_) < before)) return;
    }
  }

  SymmetrySearch result() const {
    const bool by_k = ratio(best_->departure_k(), limit_k_) > ratio(best_->departure_gamma(), limit_gamma_);
    SymmetrySearch r;
    r.departure = by_k ? ratio(best_->departure_k(), s_.norm_k) : ratio(best_->departure_gamma(), s_.norm_gamma);
    r.threshold = by_k ? ratio(limit_k_, s_.norm_k) : ratio(limit_gamma_, s_.norm_gamma);
    r.amplification = r.threshold / (safety * n_ * epsilon);
    return r;
  }

 private:
  static constexpr double safety = allowance, near = 0.1;

  double unit(double norm) const { return norm > 0 ? norm / std::sqrt(n_) : 1; }
  double worst(const Reflection& r) const { return std::max(ratio(r.departure_k(), limit_k_), ratio(r.departure_gamma(), limit_gamma_)); }
  void take(Reflection r) {
    if (!best_ || worst(r) < worst(*best_)) best_ = std::move(r);
  }

  const Normalised& s_;
  double n_, unit_k_, unit_gamma_, limit_k_, limit_gamma_;
  std::optional<Reflection> best_;
};

// One number a column of P, n × n in physical coordinates: a random error of one unit in the last place of every entry
// of a matrix, relative to the largest of its row, becomes ε ρ_i ρ_k at (i, k) of PᵀδP on average.
Vector reach(const Matrix& p, const Matrix& a) { return (p.cwiseAbs2().transpose() * largest_by_row(a)).cwiseSqrt(); }

// Of every eigenvalue of k, its modulus; of those that rounding makes, the least of the others.
Vector sizes(const Vector& eigenvalues, const Vector& rounding) {
  double least = infinity;
  for (Index i = 0; i < eigenvalues.size(); ++i) {
    if (std::abs(eigenvalues(i)) > rounding(i)) least = std::min(least, std::abs(eigenvalues(i)));
  }
  return eigenvalues.cwiseAbs().cwiseMax(std::isfinite(least) ? least : 0);
}

// The conditions once more, entry by entry, in the eigenvectors of k₁ and k₂: where K is graded, norms see nothing of
// its soft part. An entry may be as large, relative to the geometric mean of its row and column, as the norms are
// allowed relative to ‖k‖ and ‖Γ‖, or as large as rounding makes it there. The largest ratio to that.
double worst_entry(const Reflection& r, const Normalised& s, const Matrix& mass, const Matrix& gyroscopic, const Matrix& stiffness) {
  const Index p = r.plus.cols(), n = s.k.rows();
  const auto one = lapack::symmetric_eigen(r.k1), two = lapack::symmetric_eigen(r.k2);
  Matrix basis(n, n);
  basis << lapack::multiply(r.plus, one.vectors), lapack::multiply(r.minus, two.vectors);
  const Matrix k = lapack::multiply_tn(basis, lapack::multiply(s.k, basis)),
               gamma = lapack::multiply_tn(basis, lapack::multiply(s.gamma, basis));
  lapack::solve_lower_transposed(s.l, basis);
  const Matrix physical = s.scale.asDiagonal() * basis;
  const Vector of_m = reach(physical, mass), of_g = reach(physical, gyroscopic), of_k = reach(physical, stiffness);
  // An error δ of M adds ½(δk + kδ) to k, and likewise to Γ.
  const Vector through_k = (k.cwiseAbs2().transpose() * of_m.cwiseAbs2()).cwiseSqrt(),
               through_gamma = (gamma.cwiseAbs2().transpose() * of_m.cwiseAbs2()).cwiseSqrt();
  const double many = allowance * static_cast<double>(n);
  const Vector size_k = sizes(k.diagonal(), many * epsilon * (of_k.cwiseAbs2() + 2 * of_m.cwiseProduct(through_k))),
               size_gamma = gamma.colwise().norm().transpose();
  double worst = 0;
  for (Index j = 0; j < n; ++j) {
    for (Index i = 0; i < j; ++i) {
      const bool across = (i < p) != (j < p);
      const double entry = std::abs(across ? k(i, j) : gamma(i, j));
      const double local = across ? ratio(s.noise_k, s.norm_k) * std::sqrt(size_k(i) * size_k(j))
                                  : ratio(s.noise_gamma, s.norm_gamma) * std::sqrt(size_gamma(i) * size_gamma(j));
      const Vector& through = across ? through_k : through_gamma;
      const double own = across ? of_k(i) * of_k(j) : of_g(i) * of_g(j);
      worst = std::max(worst, ratio(entry, many * (local + epsilon * (own + of_m(i) * through(j) + of_m(j) * through(i)))));
    }
  }
  return worst;
}

// tr(Γ kΓ k²Γ) over the norms of its three factors. Of matrices without structure it is some n^−1.5; with an R it is
// rounding, and beside one as far as R is broken.
std::optional<SymmetrySearch> excluded_by_invariant(const Normalised& s) {
  constexpr double far = 1e-2;
  const Matrix p = lapack::multiply(s.k, s.gamma);
  const Matrix q = lapack::multiply(s.k, p);
  const Matrix gamma_p = lapack::multiply(s.gamma, p);
  const double n = static_cast<double>(s.k.rows());
  const double size = std::abs(gamma_p.cwiseProduct(q.transpose()).sum()) * std::pow(n, 1.5) / (s.norm_gamma * p.norm() * q.norm());
  const double rounding = 100 * std::pow(n, 1.5) * (ratio(s.noise_k, s.norm_k) + ratio(s.noise_gamma, s.norm_gamma) + n * epsilon);
  if (!(size > far) || !(size > rounding)) return std::nullopt;
  SymmetrySearch none;
  none.departure = size;
  none.threshold = rounding;
  return none;
}

// How far `noise` in A turns each of its eigenvectors towards its neighbours.
Vector noise_of_vectors(const Vector& ascending, double noise) {
  const Index n = ascending.size();
  Vector turned(n);
  for (Index i = 0; i < n; ++i) {
    double gap = infinity;
    if (i > 0) gap = ascending(i) - ascending(i - 1);
    if (i + 1 < n) gap = std::min(gap, ascending(i + 1) - ascending(i));
    turned(i) = noise * (1 + 1 / std::max(gap, noise));
  }
  return turned;
}

}  // namespace

ReversingSymmetry ReversingSymmetry::in_units(const Units& units) const {
  const auto inverse = units.coordinate.cwiseInverse();
  const double t = units.time;
  return {inverse.asDiagonal() * in_phase, inverse.asDiagonal() * in_quadrature, t * coupling, t * (t * stiffness1), t * (t * stiffness2)};
}

Matrix ReversingSymmetry::reflection(const Matrix& mass) const {
  return 2 * lapack::multiply(in_phase, lapack::multiply_tn(in_phase, mass)) - Matrix::Identity(mass.rows(), mass.rows());
}

SymmetrySearch find_reversing_symmetry(const Matrix& mass, const Matrix& gyroscopic, const Matrix& stiffness, bool quick) {
  const Normalised s = normalised(mass, gyroscopic, stiffness);
  if (quick) {
    if (const auto excluded = excluded_by_invariant(s)) return *excluded;
  }
  Search search(s);
  const auto e = lapack::hermitian_eigen(hermitian_combination(s, search.unit_k(), search.unit_gamma()));
  const double noise = epsilon * static_cast<double>(mass.rows()) + s.noise_k / search.unit_k() + s.noise_gamma / search.unit_gamma();
  // Eigenvectors mix by noise over distance: within a cluster at will, across clusters by a tenth at most.
  Conjugation conjugation(e.vectors, clusters_of(e.values, 10 * noise));
  const Vector noise_of_each = noise_of_vectors(e.values, noise);
  search.consider(sign_of(conjugation.by_strongest_couplings(noise_of_each)));
  search.turn();
  // With every eigenvector of A clear of noise the phases are necessary conditions: far off, there is nothing to be
  // found.
  constexpr double clear = 1e-3;
  const bool open = search.near_miss() || conjugation.unknowns() > mass.rows() || noise_of_each.maxCoeff() > clear;
  if (!search.found() && open && conjugation.unknowns() <= affordable_unknowns) {
    conjugation.decompose();
    search.draw(conjugation, noise);
    search.turn();
  }
  SymmetrySearch result = search.result();
  if (!search.found()) return result;
  const double entry = worst_entry(search.best(), s, mass, gyroscopic, stiffness);
  constexpr double more = 8;  // a largest entry is more than the average that norms are compared with
  if (!(entry <= more)) {     // in units of the threshold, as the norms cannot show it
    result.departure = entry * result.threshold;
    return result;
  }
  const auto to_physical = [&](Matrix v) {
    lapack::solve_lower_transposed(s.l, v);
    return Matrix(s.scale.asDiagonal() * v);
  };
  const Reflection& r = search.best();
  result.found = ReversingSymmetry{to_physical(r.plus), to_physical(r.minus), r.b, r.k1, r.k2};
  return result;
}

}  // namespace gyromode
