#include "gyromode/elements/quadratic_energy.h"

namespace gyromode {

QuadraticEnergy::QuadraticEnergy(Index coordinates, double spin)
    : spin_(spin), m_(Matrix::Zero(coordinates, coordinates)), g_(m_), k_(m_) {}

void QuadraticEnergy::add_point(double mass, const Eigen::Vector3d& p) {
  const LinearForm none[3];
  add_point(mass, p, none);
}

void QuadraticEnergy::add_point(double mass, const Eigen::Vector3d& p, const LinearForm (&u)[3]) {
  // r₁ by axis: ζ + θ × p + u.
  LinearForm r[3];
  const double cross[3][3] = {{0, p(2), -p(1)}, {-p(2), 0, p(0)}, {p(1), -p(0), 0}};
  for (int axis = 0; axis < 3; ++axis) {
    r[axis].add(axis, 1);
    for (int i = 0; i < 3; ++i) {
      if (cross[axis][i] != 0) r[axis].add(3 + i, cross[axis][i]);
    }
    for (std::size_t k = 0; k < u[axis].index.size(); ++k) r[axis].add(u[axis].index[k], u[axis].value[k]);
  }
  const auto products = [](const LinearForm& a, const LinearForm& b, auto&& put) {
    for (std::size_t i = 0; i < a.index.size(); ++i) {
      for (std::size_t k = 0; k < b.index.size(); ++k) put(a.index[i], b.index[k], a.value[i] * b.value[k]);
    }
  };
  for (int axis = 0; axis < 3; ++axis) {
    products(r[axis], r[axis], [&](Index i, Index k, double x) {
      m_(i, k) += mass * x;
      if (axis < 2) k_(i, k) -= mass * spin_ * spin_ * x;  // ½|Ω × r₁|²
    });
  }
  // ṙ₁·(Ω × r₁) = Ω(ṙ_y r_x − ṙ_x r_y): q̇ᵀ A q, G = A − Aᵀ.
  products(r[1], r[0], [&](Index i, Index k, double x) {
    g_(i, k) += 2 * mass * spin_ * x;
    g_(k, i) -= 2 * mass * spin_ * x;
  });
  // −mΩ² (Pp)·r₂: ½θ × (θ × p) = ½((θ·p)θ − |θ|²p), and θ × u by axis.
  const double force[3] = {mass * spin_ * spin_ * p(0), mass * spin_ * spin_ * p(1), 0};
  const double radial = force[0] * p(0) + force[1] * p(1);
  for (int i = 0; i < 3; ++i) {
    k_(3 + i, 3 + i) += radial;
    for (int k = 0; k < 3; ++k) k_(3 + i, 3 + k) -= 0.5 * (force[i] * p(k) + force[k] * p(i));
  }
  // force·(θ × u) = θ·(u × force).
  const auto couple = [&](int theta, int axis, double f) {
    for (std::size_t k = 0; k < u[axis].index.size(); ++k) {
      k_(3 + theta, u[axis].index[k]) -= f * u[axis].value[k];
      k_(u[axis].index[k], 3 + theta) -= f * u[axis].value[k];
    }
  };
  couple(0, 1, force[2]);
  couple(0, 2, -force[1]);
  couple(1, 2, force[0]);
  couple(1, 0, -force[2]);
  couple(2, 0, force[1]);
  couple(2, 1, -force[0]);
}

void QuadraticEnergy::add_stiffness(double weight, const LinearForm& form) {
  for (std::size_t i = 0; i < form.index.size(); ++i) {
    for (std::size_t k = 0; k < form.index.size(); ++k) k_(form.index[i], form.index[k]) += weight * form.value[i] * form.value[k];
  }
}

}  // namespace gyromode
