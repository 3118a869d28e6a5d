#include "gyromode/spacecraft/spacecraft_impedance.h"

#include "gyromode/appendage/hub_impedance.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"
#include "gyromode/appendage/cable.h"
#include "gyromode/appendage/beam.h"
#include "gyromode/appendage/spring_mass.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// Places and products of inertia up to this fraction of the whole satellite are rounding of sums that cancel, and
// exactly zero.
constexpr double negligible = 64 * epsilon;

struct Units {
  double mass, length, time;
  double extent;  // √(∫p² dm / m), in m

  double place(double x) const { return std::abs(x) <= negligible * extent ? 0 : x / length; }
  Cable of(Cable c, double centre) const {
    c.height = place(c.height - centre);
    c.radius /= length;
    c.length /= length;
    c.line_density *= length / mass;
    c.tip_mass /= mass;
    return c;
  }
  Beam of(Beam b, double centre) const {
    b.root_height = place(b.root_height - centre);
    b.length /= length;
    b.line_density *= length / mass;
    b.tip_mass /= mass;
    for (double& e : b.bending_stiffness) e *= time * time / (mass * length * length * length);
    return b;
  }
  SpringMass of(SpringMass m, double centre) const {
    m.position = (m.position - Eigen::Vector3d(0, 0, centre)).unaryExpr([&](double x) { return place(x); }).eval();
    m.mass /= mass;
    m.stiffness *= time * time / mass;
    return m;
  }
};

// Cables with one field together, in the order of their first.
std::vector<std::vector<Cable>> groups_of(const std::vector<Cable>& cables) {
  std::vector<std::vector<Cable>> groups;
  for (const Cable& c : cables) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.front().same_field(c); });
    if (group != groups.end())
      group->push_back(c);
    else
      groups.push_back({c});
  }
  return groups;
}

Index neutral_patterns_of(const std::vector<Cable>& cables) {
  Matrix felt(4, 0);
  for (const Cable& c : cables) {
    if (c.radius != 0) continue;
    const Eigen::Vector3d e = c.direction();
    felt.conservativeResize(4, felt.cols() + 1);
    felt.rightCols(1) << -c.first_moment() * e(1), c.first_moment() * e(0), -c.first_moment() * c.height * e(1),
        c.first_moment() * c.height * e(0);
  }
  if (felt.cols() == 0) return 0;
  for (Index i = 0; i < 4; ++i) felt.row(i).normalize();
  return felt.cols() - small::ranked_qr(felt, 1e-12).rank;
}

}  // namespace

SpacecraftImpedance::SpacecraftImpedance(const Spacecraft& s)
    : spin_(s.spin()), mass_(s.rigid().mass), continuous_(!s.cables().empty() || !s.beams().empty()) {
  const Eigen::Matrix3d j = s.rigid().inertia();
  length_ = std::sqrt(j(2, 2) / mass_);
  inertia_ = j / j(2, 2);
  if (std::abs(inertia_(0, 1)) <= negligible * std::sqrt(inertia_(0, 0) * inertia_(1, 1))) inertia_(0, 1) = inertia_(1, 0) = 0;
  const Units units{mass_, length_, 1 / spin_, std::sqrt(s.rigid().second.trace() / mass_)};
  neutral_patterns_ = neutral_patterns_of(s.cables());
  for (const auto& group : groups_of(s.cables())) {
    std::vector<Cable> scaled;
    for (const Cable& c : group) scaled.push_back(units.of(c, s.centre()));
    take(std::make_unique<CableGroup>(std::move(scaled), 1));
  }
  wire_phase_ = s.cables().empty() ? 0 : 2;
  for (const Beam& b : s.beams()) {
    const double soft = std::min(b.bending_stiffness[0], b.bending_stiffness[1]);
    beam_phase_ = std::max(beam_phase_, std::sqrt(std::sqrt(b.line_density * spin_ * spin_ / soft)) * b.length);
  }
  for (const Beam& b : s.beams()) take(std::make_unique<BeamAppendage>(units.of(b, s.centre()), 1));
  for (const SpringMass& m : s.masses()) take(std::make_unique<SpringMassAppendage>(units.of(m, s.centre()), 1));
}

void SpacecraftImpedance::take(std::unique_ptr<Appendage> appendage) {
  const Index own = appendage->coordinates();
  parts_.push_back({std::move(appendage), size_});
  size_ += own;
}

double SpacecraftImpedance::tilt_scale(double omega) const {
  return 1 / std::sqrt((1 + omega * omega) * std::max({1.0, inertia_(0, 0), inertia_(1, 1)}));
}

// The frozen satellite: −m on ξ, −J33 on φ3, and on θ1, θ2 (docs/booms.md (B3))
//     [Ω²(J33 − J22) − ω²J11    (Ω² − ω²)J12 − jωΩ(J11 + J22 − J33)]
//     [·                        Ω²(J33 − J11) − ω²J22              ].
template <class T>
void SpacecraftImpedance::add_all(const T& omega, Lifted& to) const {
  to.matrix.setZero(size_, size_);
  to.poles_below.assign(static_cast<std::size_t>(size_), 0);
  const Eigen::Matrix3d& j = inertia_;
  const Complex gyroscopic = Complex(0, 1) * (j(0, 0) + j(1, 1) - j(2, 2)) * omega;
  const T square = omega * omega;
  ComplexMatrix& h = to.matrix;
  h(0, 0) = h(1, 1) = h(2, 2) = h(5, 5) = -1;
  h(3, 3) = (j(2, 2) - j(1, 1)) - square * j(0, 0);
  h(4, 4) = (j(2, 2) - j(0, 0)) - square * j(1, 1);
  h(3, 4) = (1.0 - square) * j(0, 1) - gyroscopic;
  h(4, 3) = (1.0 - square) * j(0, 1) + gyroscopic;
  for (const Part& part : parts_) part.appendage->add(omega, to, part.first);
  const double scale = tilt_scale(omega);
  h.middleRows<2>(3) *= scale;
  h.middleCols<2>(3) *= scale;
}

// As add_all() writes them.
Couplings SpacecraftImpedance::couplings() const {
  Couplings c(size_);
  if (inertia_(0, 1) != 0) c.add(3, 4, CouplingKind::in_phase);
  if (inertia_(0, 0) + inertia_(1, 1) - inertia_(2, 2) != 0) c.add(3, 4, CouplingKind::cross);
  for (const Part& part : parts_) part.appendage->couple(c, part.first);
  return c;
}

Lifted SpacecraftImpedance::at(double omega) const {
  Lifted l;
  add_all(omega, l);
  return l;
}

ComplexMatrix SpacecraftImpedance::at(Complex omega) const {
  Lifted l;
  add_all(omega, l);
  return std::move(l.matrix);
}

// Errors of the fields grow as their phase: some 2ω/Ω in a wire (appendage/wire_field.h), (ρω²l⁴/EI)^¼ in a boom.
double SpacecraftImpedance::rounding(double omega) const {
  return epsilon * (static_cast<double>(size_) + wire_phase_ * omega + beam_phase_ * std::sqrt(omega + 1));
}

// In the plane ζ is minus the first moment of the motion relative to the body, as the mass centre rests; B⁻¹ξ is not to
// be had at Ω.
ComplexVector SpacecraftImpedance::body_motion(double omega, const ComplexVector& x) const {
  const ComplexVector y = body_vector(omega, x);
  Eigen::Vector2cd moment = Eigen::Vector2cd::Zero();
  for (const Part& part : parts_) moment += part.appendage->first_moment(omega, y, x.segment(part.first, part.appendage->coordinates()));
  ComplexVector q(6);
  q << -length_ * moment(0), -length_ * moment(1), length_ * y(2) / omega, y(3), y(4), y(5) / omega;
  return q;
}

ComplexVector SpacecraftImpedance::body_vector(double omega, const ComplexVector& x) const {
  ComplexVector y = x.head<body_coordinates>();
  y.segment<2>(3) *= tilt_scale(omega);
  return y;
}

ComplexMatrix SpacecraftImpedance::hub(double omega) const {
  const double w = omega / spin_;
  Lifted l = at(w);
  l.matrix.middleRows<2>(3) /= tilt_scale(w);
  l.matrix.middleCols<2>(3) /= tilt_scale(w);
  HubMatrix t = body_coordinates_of(w, 1);
  for (Index i = 0; i < 3; ++i) t.col(i) /= length_;
  return mass_ * length_ * length_ * spin_ * spin_ * (t.adjoint() * condensed(l) * t);
}

Eigen::Matrix2cd SpacecraftImpedance::tilt(double omega) const {
  const ComplexMatrix h = at(omega).matrix;
  const std::vector<Index> kept{3, 4};
  std::vector<Index> others;
  for (Index i = 0; i < size_; ++i) {
    if (i != 3 && i != 4) others.push_back(i);
  }
  const ComplexMatrix border = h(others, kept);
  return h(kept, kept) - border.adjoint() * small::solve_fully_pivoted(h(others, others), border);
}

}  // namespace gyromode
