#include "gyromode/sparse/folding.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <numbers>

namespace gyromode::sparse {

namespace {

double entry(const SparseMatrix& lower, Index i, Index j, double sign) { return i >= j ? lower.coeff(i, j) : sign * lower.coeff(j, i); }

}  // namespace

Departure departure_of(const SparseMatrices& m, const Involution& s) {
  Departure worst;
  const auto look = [&](const SparseMatrix& a, char name, double transposed, double kept, const auto& scale) {
    for (Index j = 0; j < a.outerSize(); ++j) {
      for (SparseMatrix::InnerIterator it(a, j); it; ++it) {
        const Index i = it.row(), p = s.partner[static_cast<std::size_t>(i)], q = s.partner[static_cast<std::size_t>(j)];
        const double sign = kept * s.sign[static_cast<std::size_t>(i)] * s.sign[static_cast<std::size_t>(j)];
        const double off = std::abs(it.value() - sign * entry(a, p, q, transposed)), size = scale(i, j);
        if (off > worst.largest * size) worst = {off / size, name, i, j};
      }
    }
  };
  for (const auto& [a, name] : {std::pair(&m.mass, 'M'), {&m.stiffness, 'K'}}) {
    const Vector diagonal = a->diagonal().cwiseAbs();
    const double least = diagonal.maxCoeff() * 1e-16;
    look(*a, name, 1, 1, [&](Index i, Index j) { return std::sqrt(std::max(diagonal(i), least) * std::max(diagonal(j), least)); });
  }
  const double largest = m.gyroscopic.nonZeros() > 0 ? m.gyroscopic.coeffs().cwiseAbs().maxCoeff() : 0;
  if (largest > 0) look(m.gyroscopic, 'G', -1, -1, [&](Index, Index) { return largest; });
  return worst;
}

namespace {

// FᵀAF of a symmetric (transposed = 1) A that S keeps (kept = 1), or a skew one (−1) that it reverses (−1), by its
// lower triangle. Of rows i that are first of a pair or alone, and any column j:
//     both in pairs:  A_ij + s_j A_ij' between the even ones (of a kept A) …, A_ij − s_j A_ij' between the odd ones
SparseMatrix folded_matrix(const SparseMatrix& a, const Involution& s, double transposed, double kept) {
  const Index n = a.cols();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(a.nonZeros()) + static_cast<std::size_t>(a.nonZeros()) / 8);
  const auto put = [&](Index i, Index j, double value) {  // of the result, below or on the diagonal
    if (i >= j && value != 0) entries.emplace_back(static_cast<int>(i), static_cast<int>(j), value);
  };
  constexpr double root = std::numbers::sqrt2 / 2;
  // What q_i of the old coordinates is made of: the even one e and, of a pair, the odd one o.
  const auto see = [&](Index i, Index j, double value) {
    const auto at = [](Index k) { return static_cast<std::size_t>(k); };
    const Index p = s.partner[at(i)], q = s.partner[at(j)];
    const Index ei = std::min(i, p), oi = std::max(i, p), ej = std::min(j, q), oj = std::max(j, q);
    const bool pair_i = p != i, pair_j = q != j;
    // q_i = c (p_e + t p_o): of a pair c = 1/√2, or sign/√2 for its second, t = 1 or −1.
    const double ci = !pair_i ? 1 : (i == ei ? 1.0 : s.sign[at(i)]) * root, cj = !pair_j ? 1 : (j == ej ? 1.0 : s.sign[at(j)]) * root;
    const double ti = i == ei ? 1 : -1, tj = j == ej ? 1 : -1;
    const double v = ci * cj * value;
    const bool even_i = pair_i || s.sign[at(i)] > 0, even_j = pair_j || s.sign[at(j)] > 0;
    // Couplings that a kept or reversed A does not have are left out: they cancel but for the departure.
    const auto couple = [&](Index r, bool r_even, Index c, bool c_even, double x) {
      if ((kept > 0) == (r_even == c_even)) put(r, c, x);
    };
    couple(ei, even_i, ej, even_j, v);
    if (pair_j) couple(ei, even_i, oj, false, v * tj);
    if (pair_i) couple(oi, false, ej, even_j, v * ti);
    if (pair_i && pair_j) couple(oi, false, oj, false, v * ti * tj);
  };
  for (Index j = 0; j < n; ++j) {
    for (SparseMatrix::InnerIterator it(a, j); it; ++it) {
      see(it.row(), j, it.value());
      if (it.row() != j) see(j, it.row(), transposed * it.value());
    }
  }
  SparseMatrix result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

constexpr double root_half = std::numbers::sqrt2 / 2;

// Every pair i < partner(i), with its sign.
template <class See>
void each_pair(const Involution& s, const See& see) {
  for (std::size_t i = 0; i < s.partner.size(); ++i) {
    if (s.partner[i] > static_cast<Index>(i)) see(static_cast<Index>(i), s.partner[i], static_cast<double>(s.sign[i]));
  }
}

}  // namespace

Matrix folded(const Involution& s, const Matrix& q) {
  Matrix p = q;
  each_pair(s, [&](Index i, Index other, double sign) {
    p.row(i) = root_half * (q.row(i) + sign * q.row(other));
    p.row(other) = root_half * (q.row(i) - sign * q.row(other));
  });
  return p;
}

SparseMatrices folded(const SparseMatrices& m, const Involution& s) {
  SparseMatrices f;
  auto stiffness = std::async(std::launch::async, [&] { return folded_matrix(m.stiffness, s, 1, 1); });  // the longest, beside the others
  f.mass = folded_matrix(m.mass, s, 1, 1);
  f.gyroscopic = folded_matrix(m.gyroscopic, s, -1, -1);
  f.stiffness = stiffness.get();
  f.gyroscopic_bound = m.gyroscopic_bound;
  f.translations = folded(s, m.translations);
  f.rigid = folded(s, m.rigid);
  // Nodes of pairs become one; numbers from 0 without gaps.
  std::vector<int> fresh(m.node.size(), -1);
  int next = 0;
  for (std::size_t i = 0; i < m.node.size(); ++i) {
    const auto first = std::min(i, static_cast<std::size_t>(s.partner[i]));
    int& number = fresh[static_cast<std::size_t>(m.node[first])];
    if (number < 0) number = next++;
    f.node.push_back(number);
  }
  return f;
}

ComplexVector unfolded(const Involution& s, const ComplexVector& p) {
  ComplexVector q = p;
  each_pair(s, [&](Index i, Index other, double sign) {
    q(i) = root_half * (p(i) + p(other));
    q(other) = root_half * sign * (p(i) - p(other));
  });
  return q;
}

}  // namespace gyromode::sparse
