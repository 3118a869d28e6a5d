#include "gyromode/roots/blocks.h"

#include "gyromode/lapack/small.h"
#include "gyromode/structure/quadrature.h"

#include <algorithm>

namespace gyromode {

namespace {

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

}  // namespace

std::vector<Block> blocks_of(const Couplings& couplings) {
  std::vector<Block> blocks;
  for (const Component& c : partition(couplings.graph())) {
    const Index first = couplings.first_of_equals(c.coordinates[0]);
    if (first != c.coordinates[0]) {
      std::find_if(blocks.begin(), blocks.end(), [&](const Block& b) {
        return b.coordinates[0] == first;
      })->equal_blocks.push_back(c.coordinates[0]);
      continue;
    }
    Block b;
    b.coordinates = c.coordinates;
    b.real = c.quadrature();
    b.in_quadrature.assign(c.coordinates.size(), false);
    for (const Index i : c.in_quadrature) {
      b.in_quadrature[static_cast<std::size_t>(std::find(b.coordinates.begin(), b.coordinates.end(), i) - b.coordinates.begin())] = true;
    }
    blocks.push_back(std::move(b));
  }
  return blocks;
}

BlockState state_of(const Block& block, const Lifted& lifted) {
  BlockState s;
  if (block.size() == 1) {
    s.eigenvalues = Vector::Constant(1, lifted.matrix(block.coordinates[0], block.coordinates[0]).real());
  } else if (block.real) {
    s.eigenvalues = small::symmetric_eigenvalues(real_block(block, lifted.matrix));
  } else {
    s.eigenvalues = small::hermitian_eigenvalues(complex_block(block, lifted.matrix));
  }
  for (const Index i : block.coordinates) s.poles_below += lifted.poles_below[static_cast<std::size_t>(i)];
  s.count = s.poles_below + (s.eigenvalues.array() < 0).count();
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
    const auto e = small::symmetric_eigen(real_block(block, lifted.matrix));
    values = e.values;
    vectors = e.vectors.cast<Complex>();
    for (std::size_t i = 0; i < block.coordinates.size(); ++i) {
      if (block.in_quadrature[i]) vectors.row(static_cast<Index>(i)) *= Complex(0, -1);
    }
  } else {
    const auto e = small::hermitian_eigen(complex_block(block, lifted.matrix));
    values = e.values;
    vectors = e.vectors;
  }
  BlockEigenpair found{values(position), ComplexVector::Zero(lifted.matrix.rows())};
  for (std::size_t i = 0; i < block.coordinates.size(); ++i) found.vector(block.coordinates[i]) = vectors(static_cast<Index>(i), position);
  return found;
}

}  // namespace gyromode
