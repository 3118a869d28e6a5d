#include "gyromode/impedance/blocks.h"

#include "gyromode/structure/quadrature.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <limits>

namespace gyromode {

namespace {

// Parts of entries up to this fraction of what their row and column hold are rounding.
constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();

// Any frequencies without a meaning, in units of the impedance.
constexpr double samples[] = {0.6180339887, 1.7320508076, 4.6692016091};

CouplingGraph couplings(const LiftedImpedance& impedance) {
  const Index n = impedance.size();
  CouplingGraph graph;
  graph.neighbours.resize(static_cast<std::size_t>(n));
  Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic> real = Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic>::Constant(n, n, false);
  auto imaginary = real;
  for (const double omega : samples) {
    const ComplexMatrix h = impedance.at(omega).matrix;
    const Vector size = h.cwiseAbs().rowwise().maxCoeff().cwiseSqrt();
    for (Index i = 0; i < n; ++i) {
      for (Index k = 0; k < i; ++k) {
        const double limit = rounding * size(i) * size(k);
        real(i, k) = real(i, k) || std::abs(h(i, k).real()) > limit;
        imaginary(i, k) = imaginary(i, k) || std::abs(h(i, k).imag()) > limit;
      }
    }
  }
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < i; ++k) {
      for (const auto& [coupled, kind] : {std::pair(real(i, k), CouplingKind::in_phase), std::pair(imaginary(i, k), CouplingKind::cross)}) {
        if (!coupled) continue;
        graph.neighbours[static_cast<std::size_t>(i)].push_back({k, kind});
        graph.neighbours[static_cast<std::size_t>(k)].push_back({i, kind});
      }
    }
  }
  return graph;
}

Matrix real_block(const Block& b, const ComplexMatrix& h) {
  const Index n = b.size();
  Matrix a(n, n);
  for (Index i = 0; i < n; ++i) {
    const auto si = static_cast<std::size_t>(i);
    for (Index k = 0; k < n; ++k) {
      const auto sk = static_cast<std::size_t>(k);
      const Complex z = h(b.coordinates[si], b.coordinates[sk]);
      // T = diag(1, −j): Tᴴ H T.
      a(i, k) = b.in_quadrature[si] == b.in_quadrature[sk] ? z.real() : (b.in_quadrature[sk] ? z.imag() : -z.imag());
    }
  }
  return a;
}

ComplexMatrix complex_block(const Block& b, const ComplexMatrix& h) { return h(b.coordinates, b.coordinates); }

// Equal blocks of one coordinate become one with twins.
void merge_copies(std::vector<Block>& blocks, const LiftedImpedance& impedance) {
  std::vector<Block> merged;
  std::vector<ComplexVector> diagonals;
  for (const double omega : samples) diagonals.push_back(impedance.at(omega).matrix.diagonal());
  const auto equal = [&](const Block& a, const Block& b) {
    return a.size() == 1 && b.size() == 1 &&
           std::all_of(diagonals.begin(), diagonals.end(), [&](const ComplexVector& d) { return d(a.coordinates[0]) == d(b.coordinates[0]); });
  };
  for (Block& b : blocks) {
    const auto twin = std::find_if(merged.begin(), merged.end(), [&](const Block& m) { return equal(m, b); });
    if (twin != merged.end() && b.size() == 1) twin->twins.push_back(b.coordinates[0]);
    else merged.push_back(std::move(b));
  }
  blocks = std::move(merged);
}

}  // namespace

std::vector<Block> blocks_of(const LiftedImpedance& impedance) {
  std::vector<Block> blocks;
  for (const Component& c : partition(couplings(impedance))) {
    Block b;
    b.coordinates = c.coordinates;
    b.real = c.quadrature();
    b.in_quadrature.assign(c.coordinates.size(), false);
    for (const Index i : c.in_quadrature) {
      b.in_quadrature[static_cast<std::size_t>(std::find(b.coordinates.begin(), b.coordinates.end(), i) - b.coordinates.begin())] = true;
    }
    blocks.push_back(std::move(b));
  }
  merge_copies(blocks, impedance);
  return blocks;
}

BlockState state_of(const Block& block, const Lifted& lifted) {
  BlockState s;
  if (block.size() == 1) {
    s.eigenvalues = Vector::Constant(1, lifted.matrix(block.coordinates[0], block.coordinates[0]).real());
  } else if (block.real) {
    s.eigenvalues = Eigen::SelfAdjointEigenSolver<Matrix>(real_block(block, lifted.matrix), Eigen::EigenvaluesOnly).eigenvalues();
  } else {
    s.eigenvalues = Eigen::SelfAdjointEigenSolver<ComplexMatrix>(complex_block(block, lifted.matrix), Eigen::EigenvaluesOnly).eigenvalues();
  }
  for (const Index i : block.coordinates) s.held += lifted.held[static_cast<std::size_t>(i)];
  s.count = s.held + (s.eigenvalues.array() < 0).count();
  s.size = std::max(1.0, s.eigenvalues.cwiseAbs().maxCoeff());
  Index at = 0;
  s.eigenvalues.cwiseAbs().minCoeff(&at);
  s.nearest = s.eigenvalues(at);
  return s;
}

BlockEigenpair eigenpair(const Block& block, const Lifted& lifted, Index position) {
  Vector values;
  ComplexMatrix vectors;
  if (block.real) {
    const Eigen::SelfAdjointEigenSolver<Matrix> e(real_block(block, lifted.matrix));
    values = e.eigenvalues();
    vectors = e.eigenvectors().cast<Complex>();
    for (std::size_t i = 0; i < block.coordinates.size(); ++i) {
      if (block.in_quadrature[i]) vectors.row(static_cast<Index>(i)) *= Complex(0, -1);
    }
  } else {
    const Eigen::SelfAdjointEigenSolver<ComplexMatrix> e(complex_block(block, lifted.matrix));
    values = e.eigenvalues();
    vectors = e.eigenvectors();
  }
  BlockEigenpair found{values(position), ComplexVector::Zero(lifted.matrix.rows())};
  for (std::size_t i = 0; i < block.coordinates.size(); ++i) found.vector(block.coordinates[i]) = vectors(static_cast<Index>(i), position);
  return found;
}

}  // namespace gyromode
