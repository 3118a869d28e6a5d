#include "gyromode/rotor/exact_rotor.h"

#include "gyromode/base/rounding.h"
#include "gyromode/rotor/pieces.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

constexpr double sign[4] = {1, -1, 1, -1};  // of the slope in the plane of y: y′ = −θx

}  // namespace

ExactRotor::ExactRotor(const Rotor& r) {
  const SpinFamily carried = assembled_without_shafts(r);
  mass_ = carried.mass;
  gyroscopic_ = r.parts().speed * carried.gyroscopic_per_spin;
  stiffness_ = carried.stiffness;
  scale_ = assembled(r).stiffness.diagonal().cwiseSqrt().cwiseInverse();
  each_piece(r, [&](const PieceBetween& p) {
    const auto &a = p.lower.coordinate, &b = p.upper.coordinate;
    pieces_.push_back(
        {{a[0], a[3], b[0], b[3]},
         {a[1], a[2], b[1], b[2]},
         ExactPiece::of(p.section, p.piece.material, p.piece.length, p.speed_ratio * r.parts().speed, r.parts().axial_force)});
  });
  const auto serves = [&](double omega) {
    return std::all_of(pieces_.begin(), pieces_.end(), [&](const Piece& p) { return p.exact.clamped_above(omega); });
  };
  reach_ = 1;
  while (serves(2 * reach_)) reach_ *= 2;
  while (reach_ > 0 && !serves(reach_)) reach_ /= 2;
  for (double step = reach_ / 2; step > 1e-3 * reach_; step /= 2) {
    if (serves(reach_ + step)) reach_ += step;
  }
}

// With D± = D(±ω) on z = x + jy and on x − jy: ½(D₊ + D₋) on either plane, and j½(D₊ − D₋) between them.
template <class T>
void ExactRotor::add(const Piece& p, const T& omega, ComplexMatrix& to) const {
  const Eigen::Matrix<T, 4, 4> forward = p.exact.dynamic_stiffness(omega), backward = p.exact.dynamic_stiffness(T(-omega));
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      const auto row = static_cast<Index>(i), col = static_cast<Index>(k);
      const Complex same = 0.5 * (forward(row, col) + backward(row, col)),
                    cross = Complex(0, 0.5) * (forward(row, col) - backward(row, col));
      const auto put = [&](Index a, Index b, const Complex& value) {
        if (a >= 0 && b >= 0) to(a, b) += value;
      };
      put(p.x[i], p.x[k], same);
      put(p.y[i], p.y[k], sign[i] * sign[k] * same);
      put(p.x[i], p.y[k], sign[k] * cross);
      put(p.y[i], p.x[k], -sign[i] * cross);
    }
  }
}

template <class T>
ComplexMatrix ExactRotor::impedance(const T& omega) const {
  ComplexMatrix h =
      stiffness_.cast<Complex>() + Complex(0, 1) * omega * gyroscopic_.cast<Complex>() - Complex(omega * omega) * mass_.cast<Complex>();
  for (const Piece& p : pieces_) add(p, omega, h);
  return scale_.cast<Complex>().asDiagonal() * h * scale_.cast<Complex>().asDiagonal();
}

Lifted ExactRotor::at(double omega) const { return {impedance(omega), std::vector<Index>(static_cast<std::size_t>(size()), 0)}; }
ComplexMatrix ExactRotor::at(Complex omega) const { return impedance(omega); }

double ExactRotor::rounding(double) const { return 8 * rounding_unit(size()); }

Couplings ExactRotor::couplings() const {
  Couplings c(size());
  const auto add_all = [&](const Matrix& a, CouplingKind kind) {
    for (Index i = 0; i < size(); ++i) {
      for (Index k = i + 1; k < size(); ++k) {
        if (a(i, k) != 0) c.add(i, k, kind);
      }
    }
  };
  add_all(mass_, CouplingKind::in_phase);
  add_all(stiffness_, CouplingKind::in_phase);
  add_all(gyroscopic_, CouplingKind::cross);
  const auto meet = [&](const std::array<Index, 4>& a, const std::array<Index, 4>& b, CouplingKind kind) {
    for (const Index i : a) {
      for (const Index k : b) {
        if (i >= 0 && k >= 0 && i != k) c.add(i, k, kind);
      }
    }
  };
  for (const Piece& p : pieces_) {
    meet(p.x, p.x, CouplingKind::in_phase);
    meet(p.y, p.y, CouplingKind::in_phase);
    if (p.exact.speed != 0) meet(p.x, p.y, CouplingKind::cross);
  }
  return c;
}

}  // namespace gyromode
