#include "gyromode/dense/second_order.h"

#include "gyromode/dense/general/definite.h"
#include "gyromode/dense/general/indefinite.h"
#include "gyromode/dense/mass_normal.h"
#include "gyromode/dense/singular_stiffness.h"
#include "gyromode/structure/inertia_of_k.h"

#include <fmt/format.h>

namespace gyromode::dense {

namespace {

void solve_regular(const SecondOrder& m, const StiffnessInertia& d, Spectrum& s) {
  const MassNormal normal(m.mass);
  const Matrix gamma = normal.gyroscopic(m.gyroscopic);
  if (const auto factor = StiffnessFactor::of(m.stiffness, d)) {
    ComplexModes modes = definite_modes(gamma, normal.stiffness_root(*factor));
    s.omega = std::move(modes.omega);
    s.re = std::move(modes.re);
    s.im = std::move(modes.im);
    s.solver = "general, K > 0: singular values of a real bidiagonal n × n matrix from the skew tridiagonal form of order 2n";
  } else {
    IndefiniteModes modes = indefinite_modes({gamma, normal.stiffness(m.stiffness)}, Matrix(m.size(), 0));
    s.re = modes.shapes.real();
    s.im = modes.shapes.imag();
    s.omega = std::move(modes.omega);
    s.unstable = std::move(modes.unstable);
    normal.to_physical(s.unstable);
    s.solver = fmt::format("general, K indefinite ({} negative): eigenvalues of order 2n with the Hamiltonian pairing kept", d.negative);
  }
  normal.to_physical(s.re);
  normal.to_physical(s.im);
}

}  // namespace

void solve_second_order(const SecondOrder& m, Spectrum& s) {
  const StiffnessInertia d = inertia_of_k(m.stiffness);
  s.store_stiffness(d);
  if (d.zero == 0) return solve_regular(m, d, s);
  solve_singular_stiffness({m.mass, m.gyroscopic, m.stiffness, -1}, d.null_space, s);
}

}  // namespace gyromode::dense
