#include "gyromode/dense/even_pencil.h"

#include "gyromode/dense/basis.h"
#include "gyromode/dense/pencil.h"
#include "gyromode/lapack/multiply.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode::dense {

namespace {

std::vector<EvenRoot> roots_of(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w, int depth);

ComplexMatrix times(const Matrix& a, const ComplexMatrix& x) {
  ComplexMatrix y(a.rows(), x.cols());
  y.real() = lapack::multiply(a, x.real());
  y.imag() = lapack::multiply(a, x.imag());
  return y;
}

// Every root of the projection is near a plain one, jω ≈ λ.
bool agrees(const std::vector<PencilRoot>& found, const ComplexVector& lambda) {
  constexpr double near = 1e-3;
  if (static_cast<Index>(found.size()) != lambda.size()) return false;
  for (const PencilRoot& r : found) {
    const Complex root(-r.value.imag(), r.value.real());
    const auto distance = (lambda.array() - root).abs();
    if (!(distance.minCoeff() <= near * std::abs(root))) return false;
  }
  return true;
}

// Roots of one group with Im λ > 0 that may meet on the axis: the Hermitian pencil of 𝓔 and −j𝒮 on their span.
bool resolve_group(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& vectors, std::vector<EvenRoot>& roots) {
  const ComplexMatrix q = orthonormal_basis(vectors);
  ComplexMatrix a = q.adjoint() * times(p.e, q);
  ComplexMatrix b = Complex(0, -1) * (q.adjoint() * times(p.s, q));
  a = 0.5 * (a + a.adjoint().eval());
  b = 0.5 * (b + b.adjoint().eval());
  const auto found = self_adjoint_pencil(a, b);
  if (!agrees(found, lambda)) return false;
  for (const PencilRoot& r : found) {
    if (r.value.imag() > 0) continue;  // ω and ω̄ are one quadruple: keep Re λ = −Im ω > 0
    roots.push_back({Complex(-r.value.imag(), r.value.real()), q * r.y});
  }
  return true;
}

// A group whose projection has lost its roots, as a defective one off the axis does: the plain roots, one of each quadruple.
void keep_plain(const ComplexVector& lambda, const ComplexMatrix& vectors, std::vector<EvenRoot>& roots) {
  for (Index k = 0; k < lambda.size(); ++k) {
    if (lambda(k).real() > 0) roots.push_back({lambda(k), vectors.col(k)});
  }
}

// Groups of the positions `upper` (Im λ > 0): i and k belong together where |w_iᴴ𝒮w_k| is not small beside the largest of its row, or the roots
// are within rounding of each other.
std::vector<std::vector<Index>> paired_groups(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w, const std::vector<Index>& upper) {
  constexpr double significant = 1e-4;
  constexpr double close = 1e-9;
  const Index m = static_cast<Index>(upper.size());
  ComplexMatrix z(w.rows(), m);
  for (Index k = 0; k < m; ++k) z.col(k) = w.col(upper[static_cast<std::size_t>(k)]);
  const Matrix gram = (z.adjoint() * times(p.s, z)).cwiseAbs();
  const double largest = lambda.cwiseAbs().maxCoeff();
  std::vector<Index> parent(static_cast<std::size_t>(m));
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto root = [&](Index i) {
    while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
    return i;
  };
  for (Index i = 0; i < m; ++i) {
    const double row = gram.row(i).maxCoeff();
    for (Index k = 0; k < m; ++k) {
      const Complex li = lambda(upper[static_cast<std::size_t>(i)]);
      const Complex lk = lambda(upper[static_cast<std::size_t>(k)]);
      if (i == k || std::abs(li - lk) > 0.1 * largest + 4 * std::abs(li.real())) continue;
      if (gram(i, k) > significant * row || std::abs(li - lk) <= close * largest) {
        parent[static_cast<std::size_t>(std::max(root(i), root(k)))] = std::min(root(i), root(k));
      }
    }
  }
  std::vector<std::vector<Index>> groups(static_cast<std::size_t>(m));
  for (Index i = 0; i < m; ++i) groups[static_cast<std::size_t>(root(i))].push_back(i);
  std::erase_if(groups, [](const auto& g) { return g.empty(); });
  return groups;
}

void resolve_real(const ComplexVector& lambda, const ComplexMatrix& w, const std::vector<Index>& real, std::vector<EvenRoot>& roots) {
  for (const Index i : real) {
    if (lambda(i).real() > 0) roots.push_back({lambda(i), w.col(i)});
  }
}

// Roots below 1 % of the largest, in a basis of their span: the error of the plain eigenvalues is relative to the largest.
void resolve_small(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w, const std::vector<Index>& small, std::vector<EvenRoot>& roots,
                   int depth) {
  const Matrix v = real_basis(w, lambda, small);
  const EvenPencil inner = projected(p, v);
  const auto e = plain_eigen(inner);
  for (EvenRoot& r : roots_of(inner, e.values, e.vectors, depth + 1)) roots.push_back({r.lambda, v * r.w});
}

// A limit within a factor 10 below `limit` that tears no pair or quadruple (roots of equal modulus) apart: the middle of the widest gap there, if it is
// wide enough; 0 where there is none.
double gap_below(const ComplexVector& lambda, double limit) {
  std::vector<double> moduli;
  for (const Complex& z : lambda) moduli.push_back(std::abs(z));
  std::sort(moduli.begin(), moduli.end());
  double best = 1.01;
  double place = 0;
  for (std::size_t i = 0; i + 1 < moduli.size(); ++i) {
    const double low = std::max(moduli[i], 0.1 * limit);
    const double high = std::min(moduli[i + 1], limit);
    if (moduli[i] > limit || !(high > best * low)) continue;
    best = high / low;
    place = std::sqrt(low * high);
  }
  return place;
}

std::vector<EvenRoot> roots_of(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w, int depth) {
  constexpr double small_ratio = 1e-2;
  constexpr int deepest = 12;
  if (lambda.size() == 0) return {};
  const double largest = lambda.cwiseAbs().maxCoeff();
  const double limit = depth < deepest ? gap_below(lambda, small_ratio * largest) : 0;
  std::vector<Index> small, real, upper;
  for (Index i = 0; i < lambda.size(); ++i) {
    if (std::abs(lambda(i)) < limit) {
      small.push_back(i);
    } else if (lambda(i).imag() == 0) {
      real.push_back(i);
    } else if (lambda(i).imag() > 0) {
      upper.push_back(i);
    }
  }
  std::vector<EvenRoot> roots;
  resolve_real(lambda, w, real, roots);
  for (const auto& group : paired_groups(p, lambda, w, upper)) {
    ComplexMatrix vectors(w.rows(), static_cast<Index>(group.size()));
    ComplexVector values(vectors.cols());
    for (std::size_t k = 0; k < group.size(); ++k) {
      const Index i = upper[static_cast<std::size_t>(group[k])];
      vectors.col(static_cast<Index>(k)) = w.col(i);
      values(static_cast<Index>(k)) = lambda(i);
    }
    if (!resolve_group(p, values, vectors, roots)) keep_plain(values, vectors, roots);
  }
  if (small.size() % 2 == 0 && !small.empty()) {
    resolve_small(p, lambda, w, small, roots, depth);
  } else if (!small.empty()) {  // a pair torn by the limit: keep the group whole at this level
    return roots_of(p, lambda, w, deepest);
  }
  return roots;
}

}  // namespace

lapack::GeneralEigen plain_eigen(const EvenPencil& p) { return lapack::general_eigen(Matrix(-p.s.partialPivLu().solve(p.e))); }

EvenPencil projected(const EvenPencil& p, const Matrix& v) {
  const Matrix s = lapack::multiply_tn(v, lapack::multiply(p.s, v));
  const Matrix e = lapack::multiply_tn(v, lapack::multiply(p.e, v));
  return {0.5 * (s - s.transpose()), 0.5 * (e + e.transpose())};
}

std::vector<EvenRoot> roots_of(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w) { return roots_of(p, lambda, w, 0); }

}  // namespace gyromode::dense
