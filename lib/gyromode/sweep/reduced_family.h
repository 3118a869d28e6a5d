#pragma once

#include "gyromode/lapack/triangular.h"
#include "gyromode/sweep/family_blocks.h"
#include "gyromode/sweep/quadrature_axes.h"
#include "gyromode/sweep/spin_sample.h"

#include <optional>
#include <utility>
#include <vector>

namespace gyromode {

/// The modes of a family at spins between some that were solved, from the space that their shapes span: neighbouring
/// spins share their subspaces. For families with a quadrature partition and K = K₀ > 0, so that all roots are real and
/// of positive energy; H is real symmetric in the axes T = diag(1, −j), and its count at the end of the window is that
/// of the modes.
///
/// In each block a basis V of the shapes found gives VᵀH(ω; Ω)V, whose roots are those of the family up to the square
/// of the residuals ‖H(ω)Vy‖, which are measured.
class ReducedFamily {
 public:
  /// Nothing where the family is not of that kind. `solved`: samples with shapes, all stable.
  static std::optional<ReducedFamily> from(const SpinFamily& family, const FamilyBlocks& blocks, const std::vector<SpinSample>& solved,
                                           const std::vector<OrbitCoordinates>& places);

  /// The modes below `below`, or the lowest so many, counted in the whole family; their errors hold the residuals.
  /// Nothing where the count is another, or where residuals add more than 10⁻¹⁰ to what rounding does to a frequency.
  std::optional<SpinSample> at(double spin, double below, std::optional<Index> lowest) const;
  Index order() const;  ///< of all reduced matrices together

 private:
  // VᵀAV and AV of each matrix of one block, H = K + ω(B₀ + ΩB₁) − ω²M, in coordinates where VᵀKV = 1.
  struct Block {
    Index number = 0;
    Matrix basis;                                 // n × r
    Matrix mass, constant, per_spin;              // r × r: M, B₀, B₁
    Matrix mass_root;                             // c with ccᵀ = VᵀMV
    Matrix k_basis, m_basis, b0_basis, b1_basis;  // n × r
  };
  struct Root {
    double omega = 0;
    const Block* block = nullptr;
    Vector y;
  };
  ReducedFamily() = default;
  bool take(const SpinFamily& family);
  void add_block(Index number, const Matrix& shapes);
  void add_roots(const Block& block, double spin, std::vector<Root>& to) const;
  SampledMode sampled(const Root& root, double spin, double apart) const;
  double rounding_at(double omega) const;
  Matrix impedance(double omega, double spin) const;

  QuadratureAxes axes_;
  Matrix stiffness_, mass_, constant_, per_spin_;  // K, M, B₀, B₁, n × n, real by T
  lapack::Cholesky factor_{Matrix()};              // of K
  std::vector<Block> blocks_;
  std::vector<OrbitCoordinates> places_;
  SpinSample usual_;                                 // verdict and balance, the same at every spin
  std::vector<std::pair<double, double>> rounding_;  // of every root at the spins solved: ω, and its error relative to ω
};

}  // namespace gyromode
