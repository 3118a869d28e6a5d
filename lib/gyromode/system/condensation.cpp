#include "gyromode/system/condensation.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/system/laws.h"
#include "gyromode/system/scale.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace gyromode {

namespace {

// Positions of the rows and columns of M that are zero, and of the others.
std::pair<std::vector<Index>, std::vector<Index>> parted(const Matrix& m) {
  std::vector<Index> massive, massless;
  for (Index i = 0; i < m.rows(); ++i) {
    const bool zero = (m.row(i).array() == 0).all() && (m.col(i).array() == 0).all();
    (zero ? massless : massive).push_back(i);
  }
  return {std::move(massive), std::move(massless)};
}

std::string named(const Labels& labels, const std::vector<Index>& at) {
  constexpr std::size_t most = 6;
  std::string names;
  for (std::size_t k = 0; k < at.size() && k < most; ++k)
    names += fmt::format("{}'{}'", k == 0 ? "" : ", ", labels[static_cast<std::size_t>(at[k])]);
  return at.size() > most ? names + fmt::format(" and {} more", at.size() - most) : names;
}

void require_uncoupled(const Matrix& g, const Labels& labels, const std::vector<Index>& massless) {
  for (const Index i : massless) {
    for (const Index j : massless) {
      if (g(i, j) == 0) continue;
      throw LawBroken::of("G", fmt::format("coordinates without mass must not be coupled by G among themselves: entry ({},{}) = {:.6g} "
                                           "couples {}; give them their mass, "
                                           "or leave that entry out",
                                           i + 1, j + 1, g(i, j), named(labels, {i, j})));
    }
  }
}

// K_ss held: the scaled matrix regular beyond rounding. Those that the weakest direction is made of are named.
void require_held(const Matrix& k, const Labels& labels, const std::vector<Index>& massless) {
  constexpr double regular = 1e-12;
  const auto e = lapack::symmetric_eigen(scaled(k, equilibrating_scale(k)));
  Index weakest = 0;
  const double smallest = e.values.cwiseAbs().minCoeff(&weakest), largest = e.values.cwiseAbs().maxCoeff();
  if (smallest > regular * largest) return;
  const Vector part = e.vectors.col(weakest).cwiseAbs();
  std::vector<Index> free;
  for (std::size_t i = 0; i < massless.size(); ++i) {
    if (part(static_cast<Index>(i)) > 0.1 * part.maxCoeff()) free.push_back(massless[i]);
  }
  throw LawBroken::of(
      "M", fmt::format("M must be positive definite, or stiffness must hold what has no mass: {} {} neither mass nor, with the others "
                       "held, stiffness; give it mass or stiffness, or leave it out",
                       named(labels, free), free.size() == 1 ? "has" : "have"));
}

// What rounding of the terms of a + b c leaves.
Matrix rounding_of(const Matrix& a, const Matrix& b, const Matrix& c) {
  const double each = static_cast<double>(b.cols() + 2) * epsilon;
  return each * (a.cwiseAbs() + b.cwiseAbs() * c.cwiseAbs());
}

}  // namespace

ComplexVector Condensation::expanded(Complex lambda, const ComplexVector& x) const {
  ComplexVector all(static_cast<Index>(labels.size()));
  all(massive) = x;
  all(massless) = -(follow * x) - lambda * (follow_rate * x);
  return all;
}

std::optional<Condensation> condensation(const Matrix& mass, const Matrix& gyroscopic, const Matrix& stiffness, const Labels& labels,
                                         const Admission& admission) {
  auto [m, s] = parted(mass);
  if (s.empty() || mass.rows() != mass.cols()) return std::nullopt;
  AdmittedMatrices a = admitted(mass, gyroscopic, stiffness, labels, admission);
  if (m.empty()) throw LawBroken::of("M", "M must be positive definite: it is zero, no coordinate has mass");
  require_uncoupled(a.gyroscopic, a.labels, s);
  const Matrix held = a.stiffness(s, s);
  require_held(held, a.labels, s);
  const Matrix compliance = symmetric_part(small::inverse(held));
  const Matrix k_sm = a.stiffness(s, m), g_sm = a.gyroscopic(s, m);
  const Matrix follow = compliance * k_sm, rate = compliance * g_sm;

  // G_ms = −G_smᵀ, K_ms = K_smᵀ.
  Matrix reduced_mass = symmetric_part(a.mass(m, m) + g_sm.transpose() * rate);
  Matrix reduced_g = skew_part(a.gyroscopic(m, m) + g_sm.transpose() * follow - k_sm.transpose() * rate);
  Matrix reduced_k = symmetric_part(a.stiffness(m, m) - k_sm.transpose() * follow);

  // |K_ss⁻¹| as computed is off by some s ε |K_ss⁻¹||K_ss||K_ss⁻¹|.
  const double each = static_cast<double>(s.size() + 2) * epsilon;
  const Matrix off = each * (compliance.cwiseAbs() * held.cwiseAbs() * compliance.cwiseAbs() + compliance.cwiseAbs());
  const Matrix k_abs = k_sm.cwiseAbs(), g_abs = g_sm.cwiseAbs();
  Matrix rounded_mass = rounding_of(a.mass(m, m), g_sm.transpose(), rate) + g_abs.transpose() * off * g_abs;
  Matrix rounded_g = rounding_of(a.gyroscopic(m, m), g_sm.transpose(), follow) +
                     rounding_of(Matrix::Zero(reduced_g.rows(), reduced_g.cols()), k_sm.transpose(), rate) +
                     g_abs.transpose() * off * k_abs + k_abs.transpose() * off * g_abs;
  Matrix rounded_k = rounding_of(a.stiffness(m, m), k_sm.transpose(), follow) + k_abs.transpose() * off * k_abs;

  // Not regular where M' is not.
  const lapack::Cholesky mass_of_massive(a.mass(m, m));
  const Matrix at_infinity = mass_of_massive.positive()
                                 ? symmetric_part(small::inverse(Matrix(held + g_sm * mass_of_massive.solve(g_sm.transpose()))))
                                 : Matrix(compliance);
  Labels kept;
  for (const Index i : m) kept.push_back(a.labels[static_cast<std::size_t>(i)]);
  System reduced(AdmittedMatrices{std::move(reduced_mass), std::move(reduced_g), std::move(reduced_k), std::move(kept), {}});
  return Condensation{std::move(a.labels),
                      std::move(m),
                      std::move(s),
                      std::move(reduced),
                      std::move(a.repairs),
                      follow,
                      rate,
                      at_infinity,
                      std::move(rounded_mass),
                      std::move(rounded_g),
                      std::move(rounded_k)};
}

}  // namespace gyromode
