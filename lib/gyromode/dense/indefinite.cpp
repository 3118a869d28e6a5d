#include "gyromode/dense/indefinite.h"

#include "gyromode/dense/basis.h"
#include "gyromode/dense/pencil.h"
#include "gyromode/lapack/general.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/triangular.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode::dense {

namespace {

// 𝒮 ẇ = −𝓔 w of even order, real.
struct EvenPencil {
  Matrix s, e;
};

// A root with Re λ = 0 exactly (on the axis, ω = Im λ > 0), or Re λ > 0 and Im λ ≥ 0: one of each pair or quadruple.
struct Root {
  Complex lambda;
  ComplexVector w;
};

std::vector<Root> roots_of(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w, int depth);

ComplexMatrix times(const Matrix& a, const ComplexMatrix& x) {
  ComplexMatrix y(a.rows(), x.cols());
  y.real() = lapack::multiply(a, x.real());
  y.imag() = lapack::multiply(a, x.imag());
  return y;
}

lapack::GeneralEigen plain_eigen(const EvenPencil& p) { return lapack::general_eigen(Matrix(-p.s.partialPivLu().solve(p.e))); }

EvenPencil projected(const EvenPencil& p, const Matrix& v) {
  const Matrix s = lapack::multiply_tn(v, lapack::multiply(p.s, v));
  const Matrix e = lapack::multiply_tn(v, lapack::multiply(p.e, v));
  return {0.5 * (s - s.transpose()), 0.5 * (e + e.transpose())};
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
bool resolve_group(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& vectors, std::vector<Root>& roots) {
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
void keep_plain(const ComplexVector& lambda, const ComplexMatrix& vectors, std::vector<Root>& roots) {
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

void resolve_real(const ComplexVector& lambda, const ComplexMatrix& w, const std::vector<Index>& real, std::vector<Root>& roots) {
  for (const Index i : real) {
    if (lambda(i).real() > 0) roots.push_back({lambda(i), w.col(i)});
  }
}

// Roots below 1 % of the largest, in a basis of their span: the error of the plain eigenvalues is relative to the largest.
void resolve_small(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w, const std::vector<Index>& small, std::vector<Root>& roots,
                   int depth) {
  const Matrix v = real_basis(w, lambda, small);
  const EvenPencil inner = projected(p, v);
  const auto e = plain_eigen(inner);
  for (Root& r : roots_of(inner, e.values, e.vectors, depth + 1)) roots.push_back({r.lambda, v * r.w});
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

std::vector<Root> roots_of(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w, int depth) {
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
  std::vector<Root> roots;
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

IndefiniteModes collected(Index n, const std::vector<Root>& roots, double gamma) {
  IndefiniteModes modes;
  std::vector<const Root*> vibrations;
  for (const Root& r : roots) {
    if (r.lambda.real() == 0) {
      if (r.lambda.imag() > 0) vibrations.push_back(&r);
    } else if (r.lambda.imag() == 0) {
      modes.divergence.push_back(r.lambda.real() * gamma);
    } else {
      modes.flutter.push_back(r.lambda * gamma);
      modes.flutter_shapes.conservativeResize(n, modes.flutter_shapes.cols() + 1);
      modes.flutter_shapes.rightCols(1) = r.w.head(n);
    }
  }
  std::sort(vibrations.begin(), vibrations.end(), [](const Root* a, const Root* b) { return a->lambda.imag() < b->lambda.imag(); });
  const Index m = static_cast<Index>(vibrations.size());
  modes.omega.resize(m);
  modes.shapes.resize(n, m);
  for (Index k = 0; k < m; ++k) {
    const Root& r = *vibrations[static_cast<std::size_t>(k)];
    modes.omega(k) = r.lambda.imag() * gamma;
    modes.shapes.col(k) = r.w.head(n);
  }
  return modes;
}

double time_scale(const NormalForm& form) {
  const double g = std::max(std::sqrt(form.k.norm()), form.gamma.norm());
  return g > 0 ? g : 1;
}

EvenPencil even_pencil(const NormalForm& form, double gamma) {
  const Index n = form.size();
  EvenPencil p{Matrix::Zero(2 * n, 2 * n), Matrix::Zero(2 * n, 2 * n)};
  p.s.topLeftCorner(n, n) = form.gamma / gamma;
  p.s.topRightCorner(n, n).setIdentity();
  p.s.bottomLeftCorner(n, n) = -Matrix::Identity(n, n);
  // time in units of 1/γ: 𝓔/γ
  p.e.topLeftCorner(n, n) = form.k / (gamma * gamma);
  p.e.bottomRightCorner(n, n).setIdentity();
  return p;
}

// [0 1; −k −Γ] in units of γ.
Matrix companion(const NormalForm& form, double gamma) {
  const Index n = form.size();
  Matrix a = Matrix::Zero(2 * n, 2 * n);
  a.topRightCorner(n, n).setIdentity();
  a.bottomLeftCorner(n, n) = -form.k / (gamma * gamma);
  a.bottomRightCorner(n, n) = -form.gamma / gamma;
  return a;
}

}  // namespace

IndefiniteModes indefinite_modes(const NormalForm& form, const Matrix& gyroscopic_null) {
  const Index n = form.size();
  const double gamma = time_scale(form);
  const EvenPencil p = even_pencil(form, gamma);
  if (gyroscopic_null.cols() == 0) {
    const auto e = lapack::general_eigen(companion(form, gamma));
    return collected(n, roots_of(p, e.values, e.vectors, 0), gamma);
  }
  // 𝓔(N_g, 0) = 0, so (N_g, 0)ᵀ𝒮w is constant, and zero in every motion with λ ≠ 0: those live in the complement of 𝒮(N_g, 0).
  Matrix null = Matrix::Zero(2 * n, gyroscopic_null.cols());
  null.topRows(n) = gyroscopic_null;
  const Matrix v = lapack::orthogonal_completion(lapack::multiply(p.s, null)).rightCols(2 * n - null.cols());
  const EvenPencil regular = projected(p, v);
  const auto e = plain_eigen(regular);
  auto roots = roots_of(regular, e.values, e.vectors, 0);
  for (Root& r : roots) r.w = (v * r.w).eval();
  return collected(n, roots, gamma);
}

IndefiniteModes resolve_roots(const NormalForm& form, const ComplexVector& lambda, const ComplexMatrix& z) {
  const Index n = form.size();
  const double gamma = time_scale(form);
  ComplexMatrix w(2 * n, z.cols());
  w.topRows(n) = z;
  w.bottomRows(n) = z * (lambda / gamma).asDiagonal();
  w.colwise().normalize();
  return collected(n, roots_of(even_pencil(form, gamma), lambda / gamma, w, 0), gamma);
}

}  // namespace gyromode::dense
