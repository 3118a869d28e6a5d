#include "gyromode/structure/reversing_symmetry.h"

#include "gyromode/lapack/hermitian.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/status.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/structure/conjugation.h"
#include "gyromode/structure/reflection.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Mass-normalised coordinates q = D L⁻ᵀ z, and what one unit in the last place of every entry of M, G, K does to k and Γ there (Frobenius norms).
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
  if (lapack::cholesky(s.l)) throw lapack::Failure("the mass matrix is not numerically positive definite");
  const Matrix k = scaled(stiffness, s.scale), g = scaled(gyroscopic, s.scale);
  s.k = lapack::congruence(s.l, k);
  Matrix gamma = g;
  lapack::solve_lower(s.l, gamma);
  lapack::solve_lower_transposed_right(s.l, gamma);
  s.gamma = 0.5 * (gamma - gamma.transpose());
  s.norm_k = s.k.norm();
  s.norm_gamma = s.gamma.norm();
  // Independent errors ε√(r_i r_j), r_i the largest entry of row i, become L⁻¹EL⁻ᵀ of norm ε Σ r_i ‖L⁻¹e_i‖² on average.
  Matrix inverse = Matrix::Identity(mass.rows(), mass.rows());
  lapack::solve_lower(s.l, inverse);
  const Vector stretch = inverse.colwise().squaredNorm().transpose();
  const double noise_mass = epsilon * scaled(mass, s.scale).diagonal().dot(stretch);
  const double n = static_cast<double>(mass.rows());
  s.noise_k = epsilon * largest_by_row(k).dot(stretch) + noise_mass * s.norm_k / std::sqrt(n);
  s.noise_gamma = epsilon * largest_by_row(g).dot(stretch) + noise_mass * s.norm_gamma / std::sqrt(n);
  return s;
}

// Where the strongest couplings do not lead to a symmetry, the space of all solutions is computed for so many unknowns: about the order of the system, more with clusters.
constexpr Index affordable_unknowns = 600;

double ratio(double a, double b) { return b > 0 ? a / b : a > 0 ? std::numeric_limits<double>::infinity() : 0; }

ComplexMatrix hermitian_combination(const Normalised& s, double unit_k, double unit_gamma) {
  constexpr double alpha = 0.73;  // any number that no symmetry of a model singles out
  ComplexMatrix a(s.k.rows(), s.k.rows());
  a.real() = s.k / unit_k;
  a.imag() = (alpha / unit_gamma) * s.gamma;
  return a;
}

// Elements of the space of solutions, each a generic one, until `good` says that one is: where the space is a line to within `spread`, one is as good as
// another; where it is not, an unlucky draw can be nearly singular.
template <class Good>
void draw(const Conjugation& conjugation, double noise, Good&& good) {
  for (const double spread : {10 * noise, 1e-7, 1e-3}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SignedBasis v = sign_of(conjugation.real_element(spread, seed));
      const bool clear = v.clearness > 0.1;
      if (good(std::move(v))) return;
      if (clear) break;
    }
  }
}

}  // namespace

Matrix ReversingSymmetry::reflection(const Matrix& mass) const {
  return 2 * lapack::multiply(in_phase, lapack::multiply_tn(in_phase, mass)) - Matrix::Identity(mass.rows(), mass.rows());
}

SymmetrySearch find_reversing_symmetry(const Matrix& mass, const Matrix& gyroscopic, const Matrix& stiffness) {
  const Normalised s = normalised(mass, gyroscopic, stiffness);
  const double n = static_cast<double>(mass.rows());
  const double unit_k = s.norm_k > 0 ? s.norm_k / std::sqrt(n) : 1, unit_gamma = s.norm_gamma > 0 ? s.norm_gamma / std::sqrt(n) : 1;
  constexpr double safety = 4;
  const double limit_k = safety * n * s.noise_k, limit_gamma = safety * n * s.noise_gamma;

  const auto e = lapack::hermitian_eigen(hermitian_combination(s, unit_k, unit_gamma));
  const double noise = epsilon * n + s.noise_k / unit_k + s.noise_gamma / unit_gamma;
  // Eigenvectors mix by noise over distance: within a cluster at will, across clusters by a tenth at most.
  Conjugation conjugation(e.vectors, clusters_of(e.values, 10 * noise));

  const auto worst = [&](const Reflection& r) { return std::max(ratio(r.breach_k(), limit_k), ratio(r.breach_gamma(), limit_gamma)); };
  std::optional<Reflection> best;
  const auto take = [&](Reflection r) {
    if (!best || worst(r) < worst(*best)) best = std::move(r);
    return worst(*best) <= 1;
  };
  const auto try_out = [&](SignedBasis v) { return take(Reflection(s.k, s.gamma, std::move(v.plus), std::move(v.minus))); };
  constexpr double near = 0.1, plain = 0.05;  // of ‖k‖ and ‖Γ‖: farther off no turn is a small one; of what rounding may do: nothing to turn
  const auto turn = [&] {
    if (worst(*best) > plain && best->breach_k() <= near * s.norm_k && best->breach_gamma() <= near * s.norm_gamma) take(turned(s.k, s.gamma, *best, unit_k, unit_gamma));
  };
  try_out(sign_of(conjugation.by_strongest_couplings(10 * noise)));
  turn();
  // With every eigenvalue of A by itself the phases are necessary conditions: far off, there is nothing to be found.
  const bool near_miss = best->breach_k() <= near * s.norm_k && best->breach_gamma() <= near * s.norm_gamma;
  const bool open = near_miss || conjugation.unknowns() > mass.rows();
  if (worst(*best) > 1 && open && conjugation.unknowns() <= affordable_unknowns) {
    conjugation.decompose();
    draw(conjugation, noise, try_out);
    turn();
  }
  SymmetrySearch result;
  const bool by_k = ratio(best->breach_k(), limit_k) > ratio(best->breach_gamma(), limit_gamma);
  result.breach = by_k ? ratio(best->breach_k(), s.norm_k) : ratio(best->breach_gamma(), s.norm_gamma);
  result.threshold = by_k ? ratio(limit_k, s.norm_k) : ratio(limit_gamma, s.norm_gamma);
  result.amplification = result.threshold / (safety * n * epsilon);
  if (!(worst(*best) <= 1)) return result;
  const auto to_physical = [&](Matrix v) {
    lapack::solve_lower_transposed(s.l, v);
    return Matrix(s.scale.asDiagonal() * v);
  };
  result.found = ReversingSymmetry{to_physical(std::move(best->plus)), to_physical(std::move(best->minus)), std::move(best->b), std::move(best->k1), std::move(best->k2)};
  return result;
}

}  // namespace gyromode
