#pragma once

#include "gyromode/system/spin_family.h"

#include <optional>
#include <vector>

namespace gyromode {

/// The subspaces of ℂⁿ that M, G₀, G₁, K₀ and K₂ all leave to themselves: connected components, forward and backward
/// whirl of an isotropic rotor, the symmetry blocks of whatever other symmetry there is. A mode at any spin belongs to
/// one block; modes of one block do not cross as the spin changes, but for coincidences that a perturbation removes,
/// modes of two blocks may.
///
/// With S = K₀ + τM > 0, in coordinates where S = 1, the eigenvectors of a combination of the matrices with fixed
/// irregular weights span the blocks: two of them belong to one block where any of the matrices couples them (Murota,
/// Kanno, Kojima and Kojima 2010, Japan J. Indust. Appl. Math. 27: a generic element of the algebra). Couplings of the
/// size of rounding are none.
class FamilyBlocks {
 public:
  /// `reach`: the frequencies of interest are below it, rad per unit of time. `noise` of the entries, relative:
  /// couplings of its size are none, as those of rounding.
  FamilyBlocks(const SpinFamily& family, double reach, double noise = 0);

  Index count() const { return count_; }
  /// The squares of the parts of a shape in each block, relative to all of it (norm of S).
  Vector shares(const ComplexVector& shape) const;
  /// The block that a shape belongs to; nothing where it has parts in several.
  std::optional<Index> block_of(const ComplexVector& shape) const;
  /// Whether what it has in other blocks is no more than rounding leaves.
  bool is_pure(const ComplexVector& shape) const;
  /// Shapes, n × m, of one frequency, of which any combination is one: combinations with one block each.
  ComplexMatrix separated(const ComplexMatrix& shapes) const;

 private:
  // The generic element of one component, decomposed.
  struct Part {
    std::vector<Index> coordinates;
    ComplexMatrix rows;        // p × n_c: a shape times these is in the eigenvectors of the element
    std::vector<Index> block;  // of each row
  };
  void add_part(const SpinFamily& family, double reach, const std::vector<Index>& coordinates, const std::vector<Index>& in_quadrature,
                bool partition);
  ComplexMatrix in_eigenvectors(const Part& part, const ComplexMatrix& shapes) const;

  double noise_;
  Index count_ = 0;
  std::vector<Part> parts_;
};

}  // namespace gyromode
