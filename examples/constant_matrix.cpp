// One constant real symmetric matrix W of order n for a system of the general class: its eigenvalues are ω², whatever
// the frequency.
//
// Boland & Janssens (ESA Journal 3, 1979) make H(ω) of the general class real by a transformation that depends on ω,
// and leave a constant one to a later paper. constant_form() gives it where K ≥ 0 (docs/theory.md (T8)). The system is
// the wire of a wiresaw (Wei & Kao, J. Sound Vib. 231, 2000) by five sine functions, pressed on an elastic guide at 0.3
// of its length: the guide couples what the transport of the wire keeps apart, and no partition is left, open or
// hidden.
#include "comparison.h"

#include <gyromode/gyromode.h>
#include <gyromode/dense/constant_form.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <numbers>

using namespace gyromode;

int main() {
  constexpr Index n = 5;
  constexpr double length = 0.365, density = 1.15e-3, tension = 25, speed = 20, guide = 2e3;  // m, kg/m, N, m/s, N/m
  constexpr double mass = density * length / 2;
  Matrix g = Matrix::Zero(n, n), k = g;
  for (Index a = 0; a < n; ++a) {
    const double i = static_cast<double>(a + 1), wave = i * std::numbers::pi / length;
    k(a, a) = length / 2 * (tension - density * speed * speed) * wave * wave;
    for (Index b = 0; b < n; ++b) {
      const double j = static_cast<double>(b + 1);
      if ((a + b) % 2 != 0) g(a, b) = 4 * density * speed * i * j / (i * i - j * j);
      k(a, b) += guide * std::sin(0.3 * std::numbers::pi * i) * std::sin(0.3 * std::numbers::pi * j);
    }
  }
  const System wire(mass * Matrix::Identity(n, n), g, k);
  const Structure structure = analyse(wire);
  const dense::ConstantForm form = dense::constant_form(wire, structure);
  std::printf("%s\n", form.solver.c_str());

  Comparison check;
  check.holds("the class is general", structure.system_class() == SystemClass::general);
  check.equal("asymmetry of W", (form.w - form.w.transpose()).norm(), 0, 0);
  // From the characteristic polynomial of M⁻¹: Σω² = tr M⁻¹K + ½‖M⁻¹G‖², Πω² = det M⁻¹K.
  check.equal("tr W", form.w.trace(), k.trace() / mass + 0.5 * g.squaredNorm() / (mass * mass), 1e-13);
  check.equal("det W", form.w.determinant(), (k / mass).determinant(), 1e-12);
  const Matrix& d = form.bidiagonal.value();
  check.at_most("‖DᵀD − W‖/‖W‖", (d.transpose() * d - form.w).norm() / form.w.norm(), 1e-14);

  ModesOptions classical;  // the other method: roots of the 2n × 2n companion matrix
  classical.method = Method::companion;
  classical.shapes = true;
  const auto modes = find_modes(wire, classical).modes;
  const Vector omega2 = Eigen::SelfAdjointEigenSolver<Matrix>(form.w).eigenvalues();
  const Vector singular = Eigen::JacobiSVD<Matrix>(d).singularValues();  // descending
  for (Index i = 0; i < n; ++i) {
    const Mode& mode = modes.at(static_cast<std::size_t>(i));
    check.equal("ω² by W, and by the companion matrix [rad²/s²]", omega2(i), mode.omega * mode.omega, 1e-12);
    check.equal("ω by D, and by the companion matrix [rad/s]", singular(n - 1 - i), mode.omega, 1e-12);
    const ComplexVector u = form.displacement * mode.shape + Complex(0, mode.omega) * (form.velocity * mode.shape);
    check.at_most("‖Wu − ω²u‖/‖Wu‖ of its shape", (form.w * u - mode.omega * mode.omega * u).norm() / (form.w * u).norm(), 1e-12);
  }
  return check.exit_code();
}
