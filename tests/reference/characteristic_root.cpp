#include "reference/characteristic_root.h"

#include <boost/multiprecision/cpp_complex.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace gyromode::reference {

namespace {

using Real = boost::multiprecision::cpp_bin_float_100;
using Complex = boost::multiprecision::cpp_complex_100;
using Rows = std::vector<std::vector<Complex>>;

struct Given {
  std::vector<std::vector<Real>> m, g, k;
};

// c of the given part and (1 − c) of its mirror image: c = 1 as given, c = ½ symmetrised. Exact in 100 digits.
std::vector<std::vector<Real>> mixed(const Eigen::MatrixXd& a, double c, int sign) {
  std::vector<std::vector<Real>> all(static_cast<std::size_t>(a.rows()), std::vector<Real>(static_cast<std::size_t>(a.cols())));
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      all[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = Real(c) * Real(a(i, j)) + Real((1 - c) * sign) * Real(a(j, i));
  }
  return all;
}

// tr N⁻¹N′ = (det N)′ / det N by Gaussian elimination with partial pivoting; nothing where N is singular to the last
// digit.
std::optional<Complex> logarithmic_derivative(Rows n, Rows slope) {
  const std::size_t size = n.size();
  for (std::size_t p = 0; p < size; ++p) {
    std::size_t best = p;
    for (std::size_t i = p + 1; i < size; ++i) {
      if (abs(n[i][p]) > abs(n[best][p])) best = i;
    }
    if (abs(n[best][p]) == 0) return std::nullopt;
    std::swap(n[p], n[best]);
    std::swap(slope[p], slope[best]);
    for (std::size_t i = 0; i < size; ++i) {
      if (i == p) continue;
      const Complex factor = n[i][p] / n[p][p];
      for (std::size_t j = p; j < size; ++j) n[i][j] -= factor * n[p][j];
      for (std::size_t j = 0; j < size; ++j) slope[i][j] -= factor * slope[p][j];
    }
  }
  Complex trace = 0;
  for (std::size_t p = 0; p < size; ++p) trace += slope[p][p] / n[p][p];
  return trace;
}

Complex root(const Given& a, Complex lambda) {
  const std::size_t size = a.m.size();
  for (int step = 0; step < 60; ++step) {
    Rows n(size, std::vector<Complex>(size)), slope = n;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        n[i][j] = lambda * lambda * a.m[i][j] + lambda * a.g[i][j] + a.k[i][j];
        slope[i][j] = Real(2) * lambda * a.m[i][j] + a.g[i][j];
      }
    }
    const auto derivative = logarithmic_derivative(n, slope);
    if (!derivative) break;
    const Complex change = Real(1) / *derivative;
    lambda -= change;
    if (!(abs(change) > Real("1e-90") * abs(lambda))) break;
  }
  return lambda;
}

}  // namespace

double moved_by_asymmetry(const Eigen::MatrixXd& M, const Eigen::MatrixXd& G, const Eigen::MatrixXd& K, std::complex<double> lambda) {
  const auto at = [&](double c) { return root({mixed(M, c, 1), mixed(G, c, -1), mixed(K, c, 1)}, Complex(lambda.real(), lambda.imag())); };
  return static_cast<double>(abs(at(1) - at(0.5)));
}

double distance_to_root(const Eigen::MatrixXd& M, const Eigen::MatrixXd& G, const Eigen::MatrixXd& K, std::complex<double> lambda) {
  const Complex start(lambda.real(), lambda.imag());
  return static_cast<double>(abs(root({mixed(M, 1, 1), mixed(G, 1, -1), mixed(K, 1, 1)}, start) - start));
}

double slope_of_root(const Eigen::MatrixXd& M, const Eigen::MatrixXd& G, const Eigen::MatrixXd& K, const Eigen::MatrixXd& dM,
                     const Eigen::MatrixXd& dG, const Eigen::MatrixXd& dK, double omega) {
  const Real h("1e-40");
  const auto moved = [&](const Eigen::MatrixXd& a, const Eigen::MatrixXd& by, int sign) {
    auto all = mixed(a, 1, sign);
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
      for (Eigen::Index j = 0; j < a.cols(); ++j) all[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += h * Real(by(i, j));
    }
    return all;
  };
  const Complex here = root({mixed(M, 1, 1), mixed(G, 1, -1), mixed(K, 1, 1)}, Complex(0, omega));
  const Complex there = root({moved(M, dM, 1), moved(G, dG, -1), moved(K, dK, 1)}, here);
  return static_cast<double>((there.imag() - here.imag()) / h);
}

}  // namespace gyromode::reference
