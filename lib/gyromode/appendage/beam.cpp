#include "gyromode/appendage/beam.h"

#include "gyromode/appendage/bernoulli.h"

#include <cmath>

namespace gyromode {

// The larger κ from the formula, the smaller from the product κ₁κ₂ = ρ²(ω² − Ω²)²/(E₁E₂).
BeamImpedance::Pair BeamImpedance::decoupled(double omega) const {
  const double density = beam_.line_density;
  const double e1 = beam_.bending_stiffness[0];
  const double e2 = beam_.bending_stiffness[1];
  const double p = omega * omega + spin_ * spin_;
  const double t = 2 * omega * spin_;
  const double first = density * p / e1;
  const double second = density * p / e2;
  const double cross = density * t / std::sqrt(e1 * e2);
  const double angle = 0.5 * std::atan2(2 * cross, first - second);
  const double inertia = density * (omega - spin_) * (omega + spin_);
  Pair pair;
  pair.kappa[0] = 0.5 * (first + second) + std::hypot(0.5 * (first - second), cross);
  pair.kappa[1] = pair.kappa[0] > 0 ? inertia * inertia / (e1 * e2) / pair.kappa[0] : 0;
  pair.v << std::sqrt(e1) * std::cos(angle), -std::sqrt(e1) * std::sin(angle), std::sqrt(e2) * std::sin(angle), std::sqrt(e2) * std::cos(angle);
  return pair;
}

HubMatrix BeamImpedance::at(double omega) const {
  const Pair pair = decoupled(omega);
  Eigen::Matrix4d stiffness = Eigen::Matrix4d::Zero();  // on (X, X′, η, η′) at the root
  for (int k = 0; k < 2; ++k) {
    const Eigen::Matrix2d d = cantilever_stiffness(pair.kappa[k], beam_.length, beam_.tip_mass / beam_.line_density);
    for (Index i = 0; i < 2; ++i) {
      for (Index n = 0; n < 2; ++n) stiffness.block<2, 2>(2 * i, 2 * n) += pair.v(i, k) * pair.v(n, k) * d;
    }
  }
  // X = ζ1 + hθ2, Y = ζ2 − hθ1, slopes along the boom ±θ2 and ∓θ1; η = jY.
  const Complex j(0, 1);
  const double up = beam_.upward ? 1 : -1;
  const double h = beam_.root_height;
  Eigen::Matrix<Complex, 4, 6> root = Eigen::Matrix<Complex, 4, 6>::Zero();
  root(0, 0) = 1;
  root(0, 4) = h;
  root(1, 4) = up;
  root(2, 1) = j;
  root(2, 3) = -j * h;
  root(3, 3) = -j * up;
  HubMatrix hub = root.adjoint() * stiffness.cast<Complex>() * root;
  hub(2, 2) = -omega * omega * beam_.mass();
  return hub;
}

Index BeamImpedance::fixed_root_negative(double omega) const {
  const Pair pair = decoupled(omega);
  const double tip = beam_.tip_mass / beam_.line_density;
  return cantilever_poles_below(pair.kappa[0], beam_.length, tip) + cantilever_poles_below(pair.kappa[1], beam_.length, tip);
}

}  // namespace gyromode
