#include "gyromode/sweep/family_blocks.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/hermitian.h"
#include "gyromode/lapack/small.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/sweep/family_structure.h"
#include "gyromode/sweep/quadrature_axes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode {

namespace {

// A Hermitian matrix re + j im; im is empty where it is real.
struct Hermitian {
  Matrix re, im;
};

// Disjoint sets of 0 … n − 1.
class Sets {
 public:
  explicit Sets(Index n) : parent_(static_cast<std::size_t>(n)) { std::iota(parent_.begin(), parent_.end(), Index(0)); }
  Index of(Index i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }
  void join(Index i, Index k) { parent(of(i)) = of(k); }

 private:
  Index& parent(Index i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<Index> parent_;
};

// L with LLᵀ = K₀ + τM, τ ≥ reach² as large as that takes.
Matrix definite_factor(const Matrix& k, const Matrix& m, double reach) {
  constexpr int most = 200;
  double tau = reach * reach;
  for (int step = 0; step < most; ++step, tau *= 4) {
    const lapack::Cholesky c(Matrix(k + tau * m));
    if (c.positive()) return c.lower();
  }
  throw NotApplicable("no combination K + τM of the family is positive definite");
}

void congruence(const Matrix& lower, Hermitian& h) {
  for (Matrix* part : {&h.re, &h.im}) {
    if (part->size() == 0) continue;
    lapack::solve_lower(lower, *part);
    lapack::solve_lower_transposed_right(lower, *part);
  }
}

double norm_of(const Hermitian& h) { return std::hypot(h.re.norm(), h.im.norm()); }
void normalise(Hermitian& h) {
  const double size = norm_of(h);
  for (Matrix* part : {&h.re, &h.im}) *part /= size;
}

// What rounding mixes of a neighbour into an eigenvector of a matrix of norm 1, times a coupling of up to 1: a coupling
// up to there is none.
double couplings_from(double unit, double gap) { return 32 * unit * (1 + 1 / gap); }

// Leading eigenvectors of a combination. High frequencies have small eigenvalues, near to each other: where rounding
// would hide their couplings they are left out. Those of one eigenvalue are determined as a set, a cluster.
struct Element {
  ComplexMatrix vectors;       // n × p
  std::vector<Index> cluster;  // of each, ascending
  std::vector<double> gap;     // of each cluster to the others, relative to the largest eigenvalue

  double smallest_gap() const { return gap.empty() ? 1 : *std::min_element(gap.begin(), gap.end()); }
};

Element decomposed(const std::vector<Hermitian>& generators, double unit, double ratio) {
  constexpr double same = 1e-10, decided = 1e-3;
  const Index n = generators.front().re.rows();
  Matrix re = Matrix::Zero(n, n), im;
  double weight = 1;
  for (const Hermitian& g : generators) {
    re += weight * g.re;
    if (g.im.size() > 0) im = im.size() > 0 ? Matrix(im + weight * g.im) : Matrix(weight * g.im);
    weight *= ratio;
  }
  lapack::HermitianEigen e;
  if (im.size() == 0) {
    auto real = lapack::symmetric_eigen(std::move(re));
    e = {std::move(real.values), real.vectors.cast<Complex>()};
  } else {
    e = lapack::hermitian_eigen(re.cast<Complex>() + imaginary_unit * im.cast<Complex>());
  }
  e.values /= e.values.cwiseAbs().maxCoeff();
  // Positions of the first eigenvector of every cluster, and its gap.
  std::vector<Index> first;
  std::vector<double> gap;
  for (Index k = 0; k < n; ++k) {
    const double step = k == 0 ? 1 : e.values(k) - e.values(k - 1);
    if (step <= same) continue;
    if (!gap.empty()) gap.back() = std::min(gap.back(), step);
    first.push_back(k);
    gap.push_back(step);
  }
  Element all;
  std::vector<Index> kept;
  for (std::size_t c = 0; c < first.size(); ++c) {
    if (!(couplings_from(unit, gap[c]) < decided * std::abs(e.values(first[c])))) continue;
    for (Index k = first[c]; k < (c + 1 < first.size() ? first[c + 1] : n); ++k) {
      kept.push_back(k);
      all.cluster.push_back(static_cast<Index>(all.gap.size()));
    }
    all.gap.push_back(gap[c]);
  }
  if (kept.empty()) return {std::move(e.vectors), std::vector<Index>(static_cast<std::size_t>(n), 0), {1.0}};  // one block
  all.vectors = e.vectors(Eigen::all, kept);
  return all;
}

// The one of a few combinations whose eigenvalues are farthest apart: the weights are irregular, so that different
// blocks have different ones.
Element generic_element(const std::vector<Hermitian>& generators, double unit) {
  constexpr Index small_order = 64;
  constexpr double far = 1e-2;
  Element best = decomposed(generators, unit, -0.7390851332151607);
  if (generators.front().re.rows() > small_order) return best;
  for (const double ratio : {0.5671432904097838, -1.3247179572447460, 0.4142135623730951, -0.6180339887498949}) {
    if (best.smallest_gap() > far || generators.size() < 2) break;
    Element other = decomposed(generators, unit, ratio);
    if (other.cluster.back() > best.cluster.back() ||
        (other.cluster.back() == best.cluster.back() && other.smallest_gap() > best.smallest_gap()))
      best = std::move(other);
  }
  return best;
}

// For every eigenvector the set that it belongs to, by the couplings of the generators.
std::vector<Index> coupled(const Element& e, const std::vector<Hermitian>& generators, double unit) {
  Sets sets(static_cast<Index>(e.gap.size()));
  for (const Hermitian& g : generators) {
    ComplexMatrix c = e.vectors.adjoint() * (g.re * e.vectors);
    if (g.im.size() > 0) c += imaginary_unit * (e.vectors.adjoint() * (g.im * e.vectors));
    for (Index col = 0; col < c.cols(); ++col) {
      const auto to = static_cast<std::size_t>(e.cluster[static_cast<std::size_t>(col)]);
      for (Index row = 0; row < col; ++row) {
        const auto from = static_cast<std::size_t>(e.cluster[static_cast<std::size_t>(row)]);
        if (from != to && std::abs(c(row, col)) > couplings_from(unit, e.gap[from]) + couplings_from(unit, e.gap[to]))
          sets.join(static_cast<Index>(from), static_cast<Index>(to));
      }
    }
  }
  std::vector<Index> all;
  for (const Index c : e.cluster) all.push_back(sets.of(c));
  return all;
}

}  // namespace

FamilyBlocks::FamilyBlocks(const SpinFamily& family, double reach, double noise) : noise_(noise) {
  const Structure structure = structure_of(family);
  for (const Component& c : structure.components) add_part(family, reach, c.coordinates, c.in_quadrature, c.quadrature());
}

void FamilyBlocks::add_part(const SpinFamily& f, double reach, const std::vector<Index>& coordinates,
                            const std::vector<Index>& in_quadrature, bool partition) {
  const Index n = static_cast<Index>(coordinates.size());
  const QuadratureAxes axes(coordinates, partition ? in_quadrature : std::vector<Index>{});
  const auto own = [&](const Matrix& a) { return Matrix(a(coordinates, coordinates)); };

  const Matrix mass = own(f.mass), lower = definite_factor(own(f.stiffness), mass, reach);
  std::vector<Hermitian> generators{{mass, {}}};
  if (f.stiffness_per_spin2.size() > 0) generators.push_back({own(f.stiffness_per_spin2), {}});
  for (const Matrix* g : {&f.gyroscopic, &f.gyroscopic_per_spin}) {
    if (g->size() > 0) generators.push_back(partition ? Hermitian{axes.crossed(own(*g)), {}} : Hermitian{Matrix::Zero(n, n), own(*g)});
  }
  for (Hermitian& g : generators) congruence(lower, g);
  std::erase_if(generators, [](const Hermitian& g) { return !(norm_of(g) > 0); });
  for (Hermitian& g : generators) normalise(g);
  const double unit = std::max(noise_, rounding_unit(n));
  const Element e = generic_element(generators, unit);
  const std::vector<Index> set = coupled(e, generators, unit);
  const Index p = e.vectors.cols();
  Part part{coordinates, {}, std::vector<Index>(static_cast<std::size_t>(p))};
  part.rows = axes.given(lower * e.vectors).adjoint();  // UᴴLᵀT* = (TLU)ᴴ
  std::vector<Index> number(static_cast<std::size_t>(p), -1);
  for (std::size_t k = 0; k < part.block.size(); ++k) {
    Index& b = number[static_cast<std::size_t>(set[k])];
    if (b < 0) b = count_++;
    part.block[k] = b;
  }
  parts_.push_back(std::move(part));
}

ComplexMatrix FamilyBlocks::in_eigenvectors(const Part& part, const ComplexMatrix& shapes) const {
  return part.rows * shapes(part.coordinates, Eigen::all);
}

Vector FamilyBlocks::shares(const ComplexVector& shape) const {
  Vector all = Vector::Zero(count_);
  for (const Part& part : parts_) {
    const ComplexMatrix y = in_eigenvectors(part, shape);
    for (Index k = 0; k < y.rows(); ++k) all(part.block[static_cast<std::size_t>(k)]) += std::norm(y(k, 0));
  }
  const double sum = all.sum();
  return sum > 0 ? Vector(all / sum) : all;
}

std::optional<Index> FamilyBlocks::block_of(const ComplexVector& shape) const {
  constexpr double pure = 1 - 1e-4;
  Index at = 0;
  return shares(shape).maxCoeff(&at) >= pure ? std::optional(at) : std::nullopt;
}

bool FamilyBlocks::is_pure(const ComplexVector& shape) const {
  constexpr double others = 1e-12;  // squares
  const Vector all = shares(shape);
  return all.sum() - all.maxCoeff() <= others;
}

// The blocks are told apart by weights: Σ w_b P_b has the pure combinations as its eigenvectors.
ComplexMatrix FamilyBlocks::separated(const ComplexMatrix& shapes) const {
  const Index m = shapes.cols();
  ComplexMatrix weighted = ComplexMatrix::Zero(m, m), gram = weighted;
  for (const Part& part : parts_) {
    const ComplexMatrix y = in_eigenvectors(part, shapes);
    Vector w(y.rows());
    for (Index k = 0; k < y.rows(); ++k)
      w(k) = 1 + std::fmod(0.6180339887498949 * static_cast<double>(part.block[static_cast<std::size_t>(k)]), 1.0);
    gram += y.adjoint() * y;
    weighted += y.adjoint() * w.asDiagonal() * y;
  }
  const auto g = small::hermitian_eigen(gram);
  const ComplexMatrix unit = g.vectors * g.values.cwiseMax(epsilon * g.values.maxCoeff()).cwiseSqrt().cwiseInverse().asDiagonal();
  return shapes * (unit * small::hermitian_eigen(ComplexMatrix(unit.adjoint() * weighted * unit)).vectors);
}

}  // namespace gyromode
