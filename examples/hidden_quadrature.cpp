// Hidden quadrature: a rotor whose matrices show no quadrature partition has one in other axes, and it is found.
//
// A shaft with two discs turns at 4000 rpm on bearings of 1 MN/m across and 0.8 MN/m along the vertical: Friswell,
// Penny, Garvey & Lees, Dynamics of Rotating Machines (2010), Example 5.9.2, here with three Euler–Bernoulli elements.
// In the axes of the bearings one plane of bending moves in phase and the other in quadrature. Written in axes turned
// by 20° every coordinate meets every other, and no partition is visible; the reversing symmetry R is there all the
// same.
#include "comparison.h"

#include <gyromode/gyromode.h>

#include <numbers>

using namespace gyromode;

// [a b; c d] of the two planes of bending.
Matrix planes(const Matrix& a, const Matrix& b, const Matrix& c, const Matrix& d) {
  Matrix whole = Matrix::Zero(16, 16);
  whole.topLeftCorner(8, 8) = a, whole.topRightCorner(8, 8) = b;
  whole.bottomLeftCorner(8, 8) = c, whole.bottomRightCorner(8, 8) = d;
  return whole;
}

// Displacement and slope at 4 nodes in plane 1, then the same in plane 2, 16 coordinates; `turn`: of the axes from
// those of the bearings, rad.
System rotor(double turn) {
  constexpr double pi = std::numbers::pi, density = 7810, young = 211e9, radius = 0.025, l = 0.5, spin = 4000 * pi / 30;
  const double bending = young * pi * std::pow(radius, 4) / 4 / (l * l * l), mass = density * pi * radius * radius * l / 420;
  const Matrix k{
      {12, 6 * l, -12, 6 * l}, {6 * l, 4 * l * l, -6 * l, 2 * l * l}, {-12, -6 * l, 12, -6 * l}, {6 * l, 2 * l * l, -6 * l, 4 * l * l}};
  const Matrix m{{156, 22 * l, 54, -13 * l},
                 {22 * l, 4 * l * l, 13 * l, -3 * l * l},
                 {54, 13 * l, 156, -22 * l},
                 {-13 * l, -3 * l * l, -22 * l, 4 * l * l}};
  Matrix shaft = Matrix::Zero(8, 8), inertia = shaft, polar = shaft, bearings = shaft;
  for (Index element = 0; element < 3; ++element) {
    shaft.block(2 * element, 2 * element, 4, 4) += bending * k;
    inertia.block(2 * element, 2 * element, 4, 4) += mass * m;
  }
  for (const auto& [node, disc_radius] : {std::pair<Index, double>{1, 0.14}, {2, 0.175}}) {
    const double disc = density * pi * disc_radius * disc_radius * 0.07, about_axis = disc * disc_radius * disc_radius / 2;
    inertia(2 * node, 2 * node) += disc;
    inertia(2 * node + 1, 2 * node + 1) += about_axis / 2 + disc * 0.07 * 0.07 / 12;
    polar(2 * node + 1, 2 * node + 1) = about_axis;
  }
  bearings(0, 0) = bearings(6, 6) = 1e6;
  const double c = std::cos(turn), s = std::sin(turn);
  const Matrix none = Matrix::Zero(8, 8), across = -0.2 * s * c * bearings;
  return {planes(inertia, none, none, inertia),
          planes(none, spin * polar, -spin * polar, none),  // G is the same in all axes
          planes(shaft + (c * c + 0.8 * s * s) * bearings, across, across, shaft + (s * s + 0.8 * c * c) * bearings),
          {"u1", "u1'", "u2", "u2'", "u3", "u3'", "u4", "u4'", "v1", "v1'", "v2", "v2'", "v3", "v3'", "v4", "v4'"}};
}

int main() {
  constexpr double turn = 20 * std::numbers::pi / 180;
  const System principal = rotor(0), turned = rotor(turn);
  Comparison check;

  const Structure structure = analyse(turned);
  check.holds("in the axes of the bearings the partition is visible", analyse(principal).system_class() == SystemClass::quadrature);
  check.holds("in turned axes it is hidden", structure.system_class() == SystemClass::hidden_quadrature);
  if (check.exit_code() != 0) return 1;  // no R to show

  // R, with or without a minus sign: the mirror line lies along the first axis of the bearings, at −20°, or across it.
  const SymmetryFinding finding = Model(turned).structure().symmetries.at(0);
  const Matrix r = finding.reflection.value();
  const std::string words = in_words(r, turned.labels());
  std::printf("R: %s\n", words.c_str());
  check.holds("an axis of the bearings",
              words.find("along the line at 70°") != words.npos || words.find("along the line at -20°") != words.npos);
  const double c = std::cos(2 * turn), s = -std::sin(2 * turn);
  const Matrix one = Matrix::Identity(8, 8), mirror = planes(c * one, s * one, s * one, -c * one);
  // Rounding turns R as far as it can move two nearly equal frequencies of the planes past each other: those above 9000
  // rad/s differ by half a percent.
  check.at_most("distance of R to the mirror", std::min((r - mirror).norm(), (r + mirror).norm()), 1e-9);
  check.at_most("departure from R² = 1, RᵀKR = K, RᵀGR = −G", finding.departure, finding.threshold);

  ModesOptions by_symmetry;
  by_symmetry.method = Method::hidden;
  const auto exact = find_modes(principal), found = find_modes(turned, by_symmetry);
  check.holds("all 16 modes found and counted", found.coverage.status == CoverageStatus::complete && found.modes.size() == 16);
  for (std::size_t i = 0; i < found.modes.size(); ++i) {
    check.equal("ω [rad/s] in turned axes, and in those of the bearings", found.modes[i].omega, exact.modes.at(i).omega, 1e-12);
  }
  return check.exit_code();
}
