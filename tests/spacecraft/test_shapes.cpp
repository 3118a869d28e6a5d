// Mode shapes: the fields of the booms against the nodes of the twin, and what a shape must look like.
#include "support/random_spacecraft.h"

#include "gyromode/modes/discrete.h"
#include "gyromode/modes/spacecraft.h"

#include <gtest/gtest.h>

namespace gyromode {
namespace {

// θ × p (Eigen's cross() conjugates complex vectors).
Eigen::Vector3cd rotated(const Eigen::Vector3cd& theta, const Eigen::Vector3cd& p) {
  return {theta(1) * p(2) - theta(2) * p(1), theta(2) * p(0) - theta(0) * p(2), theta(0) * p(1) - theta(1) * p(0)};
}

// What both can say of a mode: rotations of the body, and the displacement of each boom's tip relative to it.
ComplexVector told_by_exact(const Spacecraft& s, const ModesResult& r, const Mode& m) {
  std::vector<Complex> all{m.shape(3), m.shape(4), m.shape(5)};
  const Eigen::Vector3cd zeta = m.shape.head<3>(), theta = m.shape.tail<3>();
  // Cables come in the order of their groups: find each one's outline by its tip.
  for (const Cable& c : s.cables()) {
    const Eigen::Vector3d tip = c.reach() * c.direction() + Eigen::Vector3d(0, 0, c.height);
    for (std::size_t i = 0; i < r.outlines.size(); ++i) {
      if ((r.outlines[i].points.back() - tip).norm() > 1e-9 * tip.norm()) continue;
      const Eigen::Vector3cd p = (tip - Eigen::Vector3d(0, 0, s.centre())).cast<Complex>();
      const Eigen::Vector3cd u = Eigen::Vector3cd(m.field[i].rightCols<1>()) - zeta - rotated(theta, p);
      const Eigen::Vector3d e = c.direction(), across(-e(1), e(0), 0);
      all.push_back(across.cast<Complex>().dot(u));
      all.push_back(u(2));
      EXPECT_LE(std::abs(e.cast<Complex>().dot(u)), 1e-9 * (1 + u.norm())) << "inextensible";
      break;
    }
  }
  for (const Beam& b : s.beams()) {
    const Eigen::Vector3d tip(0, 0, b.root_height + b.way() * b.length);
    for (std::size_t i = 0; i < r.outlines.size(); ++i) {
      if ((r.outlines[i].points.back() - tip).norm() > 1e-9 * tip.norm() || r.outlines[i].points.size() == 1) continue;
      const Eigen::Vector3cd p = (tip - Eigen::Vector3d(0, 0, s.centre())).cast<Complex>();
      const Eigen::Vector3cd u = Eigen::Vector3cd(m.field[i].rightCols<1>()) - zeta - rotated(theta, p);
      all.push_back(u(0));
      all.push_back(u(1));
      break;
    }
  }
  return Eigen::Map<ComplexVector>(all.data(), static_cast<Index>(all.size()));
}

ComplexVector told_by_twin(const Spacecraft& s, const System& twin, const Mode& m) {
  const auto value = [&](const std::string& label) {
    const auto at = std::find(twin.labels().begin(), twin.labels().end(), label);
    EXPECT_NE(at, twin.labels().end()) << label;
    return m.shape(at - twin.labels().begin());
  };
  const Index nodes = 12;
  std::vector<Complex> all{m.shape(0), m.shape(1), m.shape(2)};
  for (std::size_t i = 1; i <= s.cables().size(); ++i) {
    all.push_back(value("cable" + std::to_string(i) + ".across" + std::to_string(nodes)));
    all.push_back(value("cable" + std::to_string(i) + ".axial" + std::to_string(nodes)));
  }
  for (std::size_t i = 1; i <= s.beams().size(); ++i) {
    all.push_back(value("beam" + std::to_string(i) + ".u1." + std::to_string(nodes)));
    all.push_back(value("beam" + std::to_string(i) + ".u2." + std::to_string(nodes)));
  }
  return Eigen::Map<ComplexVector>(all.data(), static_cast<Index>(all.size()));
}

TEST(Shapes, FieldsOfTheBoomsAreThoseOfTheTwin) {
  std::size_t compared = 0;
  for (const std::uint64_t seed : {0u, 1u, 3u, 4u, 7u, 9u, 10u, 13u, 14u, 16u, 17u, 18u, 20u, 21u, 22u, 24u, 29u, 30u, 31u, 32u}) {
    const Spacecraft s = random_spacecraft(seed);
    const System whole = discretise(s, {1, 12});
    ModesOptions options;
    options.shapes = true;
    options.window.b = 3 * s.spin();
    const ModesResult exact = find_modes(s, options);
    const ModesResult twin = find_modes(s, Mesh{1, 12}, options);
    if (twin.coverage.status != CoverageStatus::complete) continue;
    for (const Mode& m : exact.modes) {
      if (m.kind != ModeKind::vibration) continue;
      // Alone within a thousandth, in both, and met by the twin.
      std::vector<const Mode*> near;
      std::size_t beside = 0;
      for (const Mode& t : twin.modes) {
        if (std::abs(t.omega - m.omega) < 1e-3 * m.omega) near.push_back(&t);
      }
      for (const Mode& t : exact.modes) beside += std::abs(t.omega - m.omega) < 1e-3 * m.omega ? 1 : 0;
      if (near.size() != 1 || beside != 1) continue;
      const double error = std::abs(near[0]->omega / m.omega - 1);
      if (error > 1e-7) continue;
      const ComplexVector a = told_by_exact(s, exact, m), b = told_by_twin(s, whole, *near[0]);
      ASSERT_EQ(a.size(), b.size());
      EXPECT_NEAR(std::abs(a.dot(b)), a.norm() * b.norm(), 1e-5 * a.norm() * b.norm())
          << "seed " << seed << ", omega " << m.omega / s.spin();
      ++compared;
    }
  }
  EXPECT_GE(compared, 60u);
}

// The root of every boom goes with the body, and shapes have the parts of their class.
TEST(Shapes, RootsAreHeldAndPartsArePure) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Spacecraft s = random_spacecraft(seed);
    ModesOptions options;
    options.shapes = true;
    options.window.b = 2.5 * s.spin();
    const ModesResult r = find_modes(s, options);
    for (const Mode& m : r.modes) {
      if (m.omega == 0) continue;
      for (std::size_t i = 0; i < r.outlines.size() && m.kind == ModeKind::vibration; ++i) {
        if (r.outlines[i].points.size() == 1) continue;
        const Eigen::Vector3cd p = (r.outlines[i].points.front() - Eigen::Vector3d(0, 0, s.centre())).cast<Complex>();
        const Eigen::Vector3cd body = Eigen::Vector3cd(m.shape.head<3>()) + rotated(m.shape.tail<3>(), p);
        EXPECT_LE((m.field[i].leftCols<1>() - body).norm(), 1e-9 * (1 + body.norm())) << seed;
      }
      const double largest = m.shape.cwiseAbs().maxCoeff();
      if (m.kind == ModeKind::local)
        EXPECT_EQ(largest, 0);
      else
        EXPECT_NEAR(largest, 1, 1e-12);
      if (r.structure.system_class() != SystemClass::quadrature) continue;
      for (const Complex& z : m.shape) EXPECT_TRUE(z.real() == 0 || z.imag() == 0) << seed << ": " << z.real() << " + j" << z.imag();
    }
  }
}

}  // namespace
}  // namespace gyromode
