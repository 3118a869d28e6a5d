#include "gyromode/sensitivity/parameter_slope.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

constexpr int arms = 4;
constexpr double eighth[arms] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280}, sixth[arms] = {3.0 / 4, -3.0 / 20, 1.0 / 60, 0};

std::optional<ParameterMatrices> lawful(const MatricesAt& at, double value) {
  try {
    return at(value);
  } catch (const LawBroken&) {
    return std::nullopt;
  } catch (const Unreadable&) {  // a formula that is no number there
    return std::nullopt;
  }
}

bool same_order(const ParameterMatrices& a, const ParameterMatrices& b) {
  for (std::size_t k = 0; k < a.all.size(); ++k) {
    if (a.all[k].rows() != b.all[k].rows() || a.all[k].cols() != b.all[k].cols()) return false;
  }
  return a.all.size() == b.all.size();
}

double largest(const Matrix& a) { return a.size() > 0 ? a.cwiseAbs().maxCoeff() : 0; }

// A step at 0 that changes some entry by 10⁻⁴ of the largest of its matrix.
std::optional<double> step_at_zero(const MatricesAt& at, const ParameterMatrices& here) {
  constexpr double change = 1e-4, first = 1e-9, last = 1e15;
  std::optional<double> best;
  for (double h = first; h < last; h *= 8) {
    const auto there = lawful(at, h);
    if (!there) break;
    if (!same_order(here, *there)) return std::nullopt;
    best = h;
    for (std::size_t k = 0; k < here.all.size(); ++k) {
      const double size = largest(here.all[k]);
      if (size > 0 && largest(there->all[k] - here.all[k]) >= change * size) return h;
    }
  }
  return best;
}

// The largest error of the derivatives, relative to the largest entry of each.
double error_of(const std::vector<MatrixSlope>& all) {
  double worst = 0;
  for (const MatrixSlope& s : all) {
    const double size = largest(s.value);
    if (size > 0) worst = std::max(worst, largest(s.error) / size);
  }
  return worst;
}

std::optional<std::vector<MatrixSlope>> with_step(const MatricesAt& at, const ParameterMatrices& here, double value, double h) {
  std::vector<MatrixSlope> all;
  std::vector<Matrix> changes;  // 1 where an entry does
  for (const Matrix& a : here.all) {
    all.push_back({Matrix::Zero(a.rows(), a.cols()), Matrix::Zero(a.rows(), a.cols())});
    changes.push_back(Matrix::Zero(a.rows(), a.cols()));
  }
  for (int k = 1; k <= arms; ++k) {
    const double up = value + k * h, down = value - k * h;
    const auto above = lawful(at, up), below = lawful(at, down);
    if (!above || !below || !same_order(*above, here) || !same_order(*below, here)) return std::nullopt;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Matrix difference = (above->all[i] - below->all[i]) / (0.5 * (up - down) / k);
      all[i].value += eighth[k - 1] * difference;
      changes[i] = changes[i].cwiseMax((difference.array() != 0).cast<double>().matrix());
      all[i].error += (eighth[k - 1] - sixth[k - 1]) * difference;
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].error = all[i].error.cwiseAbs() + (4 * epsilon / std::abs(h)) * here.all[i].cwiseAbs().cwiseProduct(changes[i]);
  return all;
}

}  // namespace

std::optional<std::vector<MatrixSlope>> parameter_slopes(const MatricesAt& at, double value) {
  constexpr double part = 0.02;
  constexpr int shorter = 6;
  constexpr double enough = 1e-12;
  const auto here = lawful(at, value);
  if (!here) return std::nullopt;
  const auto first = value != 0 ? std::optional(part * std::abs(value)) : step_at_zero(at, *here);
  if (!first) return std::nullopt;
  std::optional<std::vector<MatrixSlope>> best;
  double least = infinity, h = *first;
  for (int k = 0; k <= shorter; ++k, h /= 8) {
    auto all = with_step(at, *here, value, h);
    if (!all) continue;
    const double open = error_of(*all);
    if (best && !(open < least)) continue;  // rounding, or a pole between the steps
    least = open;
    best = std::move(all);
    if (least < enough) break;
  }
  return best;
}

std::optional<RootSlopes> root_slopes(const ComplexMatrix& x, const ComplexMatrix& dx, const ComplexMatrix& fx, const Matrix& error) {
  const ComplexMatrix d = x.adjoint() * dx, f = x.adjoint() * fx;
  const auto e = small::hermitian_eigen(ComplexMatrix(0.5 * (f + f.adjoint())));
  const double sign = e.values.sum() < 0 ? -1 : 1;
  if (!((sign * e.values).minCoeff() > 0)) return std::nullopt;
  const ComplexMatrix unit = e.vectors * (sign * e.values).cwiseSqrt().cwiseInverse().asDiagonal();
  const ComplexMatrix in_unit = sign * (unit.adjoint() * (0.5 * (d + d.adjoint())) * unit);
  RootSlopes r{small::hermitian_eigenvalues(in_unit), Vector(x.cols())};
  const Matrix size = (x * unit).cwiseAbs();
  if (error.size() > 0)
    r.error.setConstant((size.transpose() * error * size).norm());
  else
    r.error.setConstant(rounding_unit(x.rows()) * (size.transpose() * (dx * unit).cwiseAbs()).norm());
  return r;
}

}  // namespace gyromode
