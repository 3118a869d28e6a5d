#include "gyromode/dense/general/root_groups.h"

#include "gyromode/dense/pencil.h"
#include "gyromode/lapack/small.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode::dense {

namespace {

// The upper roots with the images of their vectors.
struct Upper {
  const ComplexVector& lambda;
  const ComplexMatrix& w;
  ComplexMatrix s, e;  // 𝒮w, 𝓔w
};

ComplexMatrix image(const EvenPencil& p, Matrix (EvenPencil::*times)(const Matrix&) const, const ComplexMatrix& w) {
  ComplexMatrix y(w.rows(), w.cols());
  y.real() = (p.*times)(w.real());
  y.imag() = (p.*times)(w.imag());
  return y;
}

using Groups = std::vector<std::vector<Index>>;

// i and k belong together where k is near the partner −λ̄_i and |w_iᴴ𝒮w_k| is not small beside the largest of its row,
// or where the roots are within rounding of each other. Only roots near −λ̄_i, or the nearest one to it, can have a form
// that is not rounding.
Groups paired_groups(const Upper& u) {
  constexpr double near_ratio = 1e-4, significant = 1e-4, close = 1e-9;
  const Index m = u.lambda.size();
  const double largest = u.lambda.cwiseAbs().maxCoeff();
  std::vector<Index> by_height(static_cast<std::size_t>(m)), parent(static_cast<std::size_t>(m));
  std::iota(parent.begin(), parent.end(), Index{0});
  by_height = parent;
  std::sort(by_height.begin(), by_height.end(), [&](Index a, Index b) { return u.lambda(a).imag() < u.lambda(b).imag(); });
  const auto root = [&](Index i) {
    while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
    return i;
  };
  const auto join = [&](Index i, Index k) { parent[static_cast<std::size_t>(std::max(root(i), root(k)))] = std::min(root(i), root(k)); };
  for (std::size_t at = 0; at < by_height.size(); ++at) {
    const Index i = by_height[at];
    const Complex mirrored = -std::conj(u.lambda(i));
    std::vector<std::pair<Index, double>> candidates;  // with |form|
    Index nearest = i;
    double distance = std::abs(u.lambda(i) - mirrored);
    const auto look = [&](std::size_t position) {
      const Index k = by_height[position];
      const double d = std::abs(u.lambda(k) - mirrored);
      if (d < distance) {
        distance = d;
        nearest = k;
      }
      if (d <= near_ratio * largest) candidates.emplace_back(k, 0);
      if (i != k && std::abs(u.lambda(i) - u.lambda(k)) <= close * largest) join(i, k);
    };
    const auto within = [&](std::size_t position) {
      return std::abs(u.lambda(by_height[position]).imag() - mirrored.imag()) <= std::max(near_ratio * largest, distance);
    };
    look(at);
    for (std::size_t above = at + 1; above < by_height.size() && within(above); ++above) look(above);
    for (std::size_t below = at; below-- > 0 && within(below);) look(below);
    if (std::none_of(candidates.begin(), candidates.end(), [&](const auto& c) { return c.first == nearest; }))
      candidates.emplace_back(nearest, 0);
    double row = 0;
    for (auto& [k, form] : candidates) {
      form = std::abs(u.w.col(i).dot(u.s.col(k)));
      row = std::max(row, form);
    }
    for (const auto& [k, form] : candidates) {
      if (k != i && form > significant * row) join(i, k);
    }
  }
  Groups groups(static_cast<std::size_t>(m));
  for (Index i = 0; i < m; ++i) groups[static_cast<std::size_t>(root(i))].push_back(i);
  std::erase_if(groups, [](const auto& g) { return g.empty(); });
  return groups;
}

// Every root of the projection is near a plain one, jω ≈ λ.
bool agrees(const std::vector<PencilRoot>& found, const ComplexVector& lambda) {
  constexpr double near = 1e-3;
  if (static_cast<Index>(found.size()) != lambda.size()) return false;
  for (const PencilRoot& r : found) {
    const Complex root(-r.value.imag(), r.value.real());
    if (!((lambda.array() - root).abs().minCoeff() <= near * std::abs(root))) return false;
  }
  return true;
}

// The left vector of root i, the vector of its mirror image. Roots that coincide to the last bit, as those of exact
// copies do, each take an image of their own.
ComplexVector partner_of(const std::vector<PencilRoot>& found, std::size_t i) {
  const Complex value = found[i].value;
  auto before =
      std::count_if(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(i), [&](const PencilRoot& r) { return r.value == value; });
  for (const PencilRoot& r : found) {
    if (r.value == std::conj(value) && before-- == 0) return r.y;
  }
  return found[i].y;
}

// Roots of one group that may meet on the axis: the Hermitian pencil of 𝓔 and −j𝒮 on their span, W = QR, 𝓔Q = (𝓔W)R⁻¹.
bool resolve(const Upper& u, const std::vector<Index>& group, std::vector<EvenRoot>& roots) {
  const small::Qr f = small::qr(u.w(Eigen::all, group));
  const ComplexMatrix& q = f.q;
  const auto onto = [&](const ComplexMatrix& image) -> ComplexMatrix {
    return q.adjoint() *
           f.r.template triangularView<Eigen::Upper>().template solve<Eigen::OnTheRight>(ComplexMatrix(image(Eigen::all, group)));
  };
  ComplexMatrix a = onto(u.e);
  ComplexMatrix b = Complex(0, -1) * onto(u.s);
  a = 0.5 * (a + a.adjoint().eval());
  b = 0.5 * (b + b.adjoint().eval());
  if (!a.allFinite() || !b.allFinite()) return false;
  const auto found = self_adjoint_pencil(a, b);
  if (!agrees(found, u.lambda(group))) return false;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const PencilRoot& root = found[i];
    if (root.value.imag() > 0) continue;  // ω and ω̄ are one quadruple: keep Re λ = −Im ω > 0
    const Complex lambda(-root.value.imag(), root.value.real());
    roots.push_back({lambda, q * root.y, lambda.real() == 0 ? ComplexVector() : ComplexVector(q * partner_of(found, i))});
  }
  return true;
}

// A group of one is on the axis: ω = wᴴ𝓔w / wᴴ(−j𝒮)w, real.
bool resolve_one(const Upper& u, Index i, std::vector<EvenRoot>& roots) {
  const double omega = u.w.col(i).dot(u.e.col(i)).real() / u.w.col(i).dot(u.s.col(i)).imag();
  if (!(std::abs(Complex(0, omega) - u.lambda(i)) <= 1e-3 * std::abs(omega))) return false;
  roots.push_back({Complex(0, omega), u.w.col(i), {}});
  return true;
}

// A group whose projection has lost its roots, as a defective one off the axis does: the plain roots, one of each
// quadruple.
void keep_plain(const Upper& u, const std::vector<Index>& group, std::vector<EvenRoot>& roots) {
  std::vector<bool> taken(group.size(), false);
  for (const Index i : group) {
    if (!(u.lambda(i).real() > 0)) continue;
    std::size_t partner = group.size();
    for (std::size_t k = 0; k < group.size(); ++k) {
      const auto distance = [&](std::size_t at) { return std::abs(u.lambda(group[at]) + std::conj(u.lambda(i))); };
      if (!taken[k] && (partner == group.size() || distance(k) < distance(partner))) partner = k;
    }
    if (partner == group.size()) continue;
    taken[partner] = true;
    roots.push_back({u.lambda(i), u.w.col(i), u.w.col(group[partner])});
  }
}

}  // namespace

std::vector<EvenRoot> roots_of_groups(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w) {
  std::vector<EvenRoot> roots;
  if (lambda.size() == 0) return roots;
  const Upper u{lambda, w, image(p, &EvenPencil::s_times, w), image(p, &EvenPencil::e_times, w)};
  for (const auto& group : paired_groups(u)) {
    const bool found = group.size() == 1 ? resolve_one(u, group[0], roots) : resolve(u, group, roots);
    if (!found) keep_plain(u, group, roots);
  }
  return roots;
}

}  // namespace gyromode::dense
