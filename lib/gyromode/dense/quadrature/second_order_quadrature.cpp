#include "gyromode/dense/mass_normal.h"
#include "gyromode/dense/quadrature/quadrature.h"
#include "gyromode/dense/second_order.h"
#include "gyromode/dense/singular_stiffness.h"
#include "gyromode/structure/inertia_of_k.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace gyromode::dense {

namespace {

// Shapes are asked for in physical coordinates; a root f = L⁻¹F leads there by F alone.
StiffnessBlock block(const MassNormal& normal, const Matrix& k, const StiffnessInertia& d) {
  StiffnessBlock::Recipe root;
  ShapeCoordinates physical{[&normal](MatrixSpan x) { normal.to_physical(x); }, {}};
  if (const auto factor = StiffnessFactor::of(k, d)) {
    root = [&normal, factor] { return normal.stiffness_root(*factor); };
    physical.from_root = [factor](MatrixSpan s) { factor->to_physical(s); };
  }
  StiffnessBlock made(
      k.rows(), [&normal, &k] { return normal.stiffness(k); }, std::move(root));
  made.ask_for(std::move(physical));
  return made;
}

void solve_regular(const SecondOrderQuadrature& m, const StiffnessInertia& d1, const StiffnessInertia& d2, Spectrum& s) {
  const MassNormal first(m.mass1);
  const MassNormal second(m.mass2);
  QuadratureModes modes =
      quadrature_modes({first.coupling(m.coupling, second), block(first, m.stiffness1, d1), block(second, m.stiffness2, d2)});
  s.re = std::move(modes.x);
  s.im = std::move(modes.y);
  s.im *= -1;
  s.solver = "quadrature: " + modes.solver;
  s.omega = std::move(modes.omega);
  s.unstable = std::move(modes.unstable);
}

StiffnessInertia of_both(const StiffnessInertia& d1, const StiffnessInertia& d2) {
  const Index n1 = d1.null_space.rows();
  StiffnessInertia d{{d1.negative + d2.negative, d1.zero + d2.zero},
                     d1.positive + d2.positive,
                     {},
                     std::min(d1.margin, d2.margin),
                     d1.doubtful || d2.doubtful,
                     {}};
  d.null_space = Matrix::Zero(n1 + d2.null_space.rows(), d.zero);
  d.null_space.topLeftCorner(n1, d1.zero) = d1.null_space;
  d.null_space.bottomRightCorner(d2.null_space.rows(), d2.zero) = d2.null_space;
  return d;
}

SingularSystem whole(const SecondOrderQuadrature& m) {
  const Index p = m.mass1.rows();
  const Index r = m.mass2.rows();
  SingularSystem s{Matrix::Zero(p + r, p + r), Matrix::Zero(p + r, p + r), Matrix::Zero(p + r, p + r), p};
  s.mass.topLeftCorner(p, p) = m.mass1;
  s.mass.bottomRightCorner(r, r) = m.mass2;
  s.gyroscopic.topRightCorner(p, r) = m.coupling;
  s.gyroscopic.bottomLeftCorner(r, p) = -m.coupling.transpose();
  s.stiffness.topLeftCorner(p, p) = m.stiffness1;
  s.stiffness.bottomRightCorner(r, r) = m.stiffness2;
  return s;
}

}  // namespace

void solve_second_order(const SecondOrderQuadrature& m, Spectrum& s) {
  solve_second_order(m, inertia_of_k(m.stiffness1), inertia_of_k(m.stiffness2), s);
}

void solve_second_order(const SecondOrderQuadrature& m, const StiffnessInertia& d1, const StiffnessInertia& d2, Spectrum& s) {
  const StiffnessInertia d = of_both(d1, d2);
  s.store_stiffness(d);
  if (d.zero == 0) return solve_regular(m, d1, d2, s);
  solve_singular_stiffness(whole(m), d.null_space, s);
}

}  // namespace gyromode::dense
