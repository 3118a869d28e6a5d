#include "gyromode/system/diagnosis.h"

#include "gyromode/lapack/symmetric.h"
#include "gyromode/system/symmetry.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace gyromode {

namespace {

constexpr double alike = 1e-6;          // relative: what people copy and print agrees to this
constexpr Index examined_up_to = 1000;  // eigenvalues cost more than an error message is worth

double largest(const Matrix& a) { return a.cwiseAbs().maxCoeff(); }
bool symmetric(const Matrix& a) { return largest(skew_part(a)) <= alike * largest(a); }
bool skew(const Matrix& a) { return largest(symmetric_part(a)) <= alike * largest(a); }

// d > 0 with d_i a_ij = ±d_j a_ji: what the rows of a matrix were divided by. Nothing where there is none, and where
// there are no more couplings than numbers to choose, so that nothing bears it out.
std::optional<Vector> divisors(const std::vector<std::pair<const Matrix*, int>>& matrices) {
  const Index n = matrices.front().first->rows();
  Vector d = Vector::Zero(n);
  Index chosen = 0, couplings = 0;
  for (Index start = 0; start < n; ++start) {
    if (d(start) > 0) continue;
    d(start) = 1;
    std::vector<Index> open{start};
    while (!open.empty()) {
      const Index i = open.back();
      open.pop_back();
      for (const auto& [a, sign] : matrices) {
        const double tiny = alike * largest(*a);
        for (Index j = 0; j < n; ++j) {
          if (j == i || std::abs((*a)(i, j)) <= tiny || std::abs((*a)(j, i)) <= tiny) continue;
          const double ratio = sign * (*a)(i, j) / (*a)(j, i);
          if (!(ratio > 0)) return std::nullopt;
          couplings += i < j;
          if (d(j) > 0) continue;
          ++chosen;
          d(j) = d(i) * ratio;
          open.push_back(j);
        }
      }
    }
  }
  if (couplings <= chosen) return std::nullopt;
  for (const auto& [a, sign] : matrices) {
    const Matrix product = d.asDiagonal() * *a;
    if (!(sign > 0 ? symmetric(product) : skew(product))) return std::nullopt;
  }
  return d;
}

std::string divided(const Matrix& mass, const Matrix& g, const Matrix& k) {
  const bool diagonal = largest(Matrix(mass - Matrix(mass.diagonal().asDiagonal()))) <= alike * largest(mass);
  if (!diagonal || g.rows() > examined_up_to || largest(k) == 0) return "";
  const auto d = divisors({{&g, -1}, {&k, 1}});
  if (!d || (d->array() - (*d)(0)).abs().maxCoeff() <= alike) return "";
  return "rows multiplied by positive numbers make G skew and K symmetric: these look like M⁻¹G and M⁻¹K, the blocks of a state matrix; "
         "give M, G and K "
         "themselves";
}

std::string exchanged(const Matrix& g, const Matrix& k) {
  return largest(g) > 0 && largest(k) > 0 && symmetric(g) && skew(k) ? "G is symmetric and K is skew: were they exchanged?" : "";
}

// The file of one matrix given for another.
std::string repeated(char a, const Matrix& one, char b, const Matrix& other) {
  if (largest(one) == 0 || one != other) return "";
  return fmt::format("{} is the same matrix as {}: was the wrong one given?", a, b);
}

// np.triu of a symmetric matrix, say: the other triangle is 0.
std::string one_triangle(char name, const Matrix& a) {
  const Matrix lower = a.triangularView<Eigen::StrictlyLower>(), upper = a.triangularView<Eigen::StrictlyUpper>();
  if ((largest(lower) == 0) == (largest(upper) == 0)) return "";
  return fmt::format(
      "only one triangle of {} is given: write both, or use a format that says so (Matrix Market, symmetric or skew-symmetric)", name);
}

std::string remedy(const Matrix& dropped, const Matrix& whole, const char* part) {
  const double size = 2 * largest(dropped) / largest(whole);
  const double power = std::pow(10, std::floor(std::log10(size))), rounded = std::ceil(size / power) * power;
  return fmt::format("--symmetrise={:.1g} (key symmetrise) uses the {} part", rounded, part);
}

}  // namespace

std::string diagnosis_of_gyroscopic(const Matrix& mass, const Matrix& g, const Matrix& k) {
  if (const std::string words = exchanged(g, k); !words.empty()) return words;
  if (const std::string words = divided(mass, g, k); !words.empty()) return words;
  if (const std::string words = repeated('G', g, 'M', mass) + repeated('G', g, 'K', k); !words.empty()) return words;
  if (const std::string words = one_triangle('G', g); !words.empty()) return words;
  const Matrix damping = symmetric_part(g);
  const std::string skew_alone = largest(skew_part(g)) > 0 ? remedy(damping, g, "skew") : "it has no skew part that would be gyroscopic";
  if (g.rows() <= examined_up_to) {
    const Vector values = lapack::symmetric_eigenvalues(damping);
    const double tiny = alike * values.cwiseAbs().maxCoeff();
    if (values(0) >= -tiny)
      return "its symmetric part is positive semidefinite: this is damping, C = (G + Gᵀ)/2, which is not served: leave it out for the "
             "undamped modes; " +
             skew_alone;
    if (values(values.size() - 1) <= tiny)
      return "its symmetric part is negative semidefinite: this is damping that feeds energy in, or damping with the wrong sign, which is "
             "not served; " +
             skew_alone;
  }
  return "its symmetric part acts as damping of both signs, as flow at a free end does, which is not served; " + skew_alone;
}

std::string diagnosis_of_stiffness(const Matrix& mass, const Matrix& g, const Matrix& k) {
  if (const std::string words = exchanged(g, k); !words.empty()) return words;
  if (const std::string words = repeated('K', k, 'G', g); !words.empty()) return words;
  if (const std::string words = one_triangle('K', k); !words.empty()) return words;
  const Matrix n = skew_part(k);
  const std::string symmetric_alone = remedy(n, k, "symmetric");
  Index pairs = 0, row = 0, column = 0;
  for (Index j = 0; j < n.cols(); ++j) {
    for (Index i = j + 1; i < n.rows(); ++i) {
      if (std::abs(n(i, j)) <= alike * largest(k)) continue;
      ++pairs;
      row = i;
      column = j;
    }
  }
  if (pairs == 1 && k.rows() > 2) {
    const double a = k(row, column), b = k(column, row);
    if (std::abs(a + b) <= alike * std::abs(a - b)) return "all other pairs agree: was a sign typed wrong?";
    return "all other pairs agree: was one of the two typed wrong? " + symmetric_alone;
  }
  if (const std::string words = divided(mass, g, k); !words.empty()) return words;
  return "its skew part is circulatory: cross-coupled stiffness of a bearing or seal, a follower force, or a damper that turns, which is "
         "not served; " +
         symmetric_alone;
}

std::string diagnosis_of_mass(const Matrix& mass, const Matrix& k) {
  if (const std::string words = one_triangle('M', mass); !words.empty()) return words;
  if (k.rows() != mass.rows() || mass.rows() > examined_up_to || !symmetric(mass) || !symmetric(k)) return "";
  if (lapack::symmetric_eigenvalues(symmetric_part(k))(0) > 0 && lapack::symmetric_eigenvalues(symmetric_part(mass))(0) < 0)
    return "K is positive definite: were M and K exchanged?";
  return "";
}

}  // namespace gyromode
