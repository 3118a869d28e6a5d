#include "gyromode/spacecraft/spacecraft.h"

#include "gyromode/base/error.h"
#include "gyromode/appendage/cable.h"
#include "gyromode/appendage/beam.h"
#include "gyromode/appendage/spring_mass.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode {

namespace {

template <class Part>
void require_laws(const std::vector<Part>& parts, const char* name) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (const auto b = broken_law(parts[i])) throw LawBroken(fmt::format("{} {}: {}", name, i + 1, b->law));
  }
}

// Mass properties of a part and the centrifugal loads that follow from them must be numbers: lengths, masses and the
// spin may each be far from 1, their products may leave the range.
void require_numbers(const MassProperties& p, double spin, const std::string& name) {
  const double square = spin * spin;
  if (std::isfinite(p.mass) && (square * p.first).allFinite() && (square * p.second).allFinite() && p.first.allFinite() &&
      p.second.allFinite() && square > 0)
    return;
  throw LawBroken(
      fmt::format("{}: mass {:.6g} kg, or its moments, or their loads at spin {:.6g} rad/s, leave the range of numbers (1e-308 to 1e308): "
                  "are the units kg, m and rad/s?",
                  name, p.mass, spin));
}

// What condition 1 and 2 are relative to: Σ∫ r dm.
double total_first_moment(const Spacecraft& s) {
  double sum = 0;
  for (const Cable& c : s.cables()) sum += c.first_moment();
  for (const SpringMass& m : s.masses()) sum += m.mass * m.position.head<2>().norm();
  return sum;
}

}  // namespace

const Labels& Spacecraft::labels() const {
  static const Labels all{"zeta1", "zeta2", "zeta3", "theta1", "theta2", "theta3"};
  return all;
}

Spacecraft::Spacecraft(double spin, Body body, std::vector<Cable> cables, std::vector<Beam> beams, std::vector<SpringMass> masses)
    : spin_(spin), body_(std::move(body)), cables_(std::move(cables)), beams_(std::move(beams)), masses_(std::move(masses)) {
  if (!(spin_ > 0) || !std::isfinite(spin_)) {
    throw LawBroken(fmt::format("spin must be above 0: it is {:.6g} rad/s{}", spin_,
                                spin_ < 0         ? " (for the other sense of rotation turn axis 3 around)"
                                : cables_.empty() ? ""
                                                  : ", and without it no cable is taut"));
  }
  if (const auto b = broken_law(body_)) throw LawBroken(fmt::format("body: {}", b->law));
  require_laws(cables_, "cable");
  require_laws(beams_, "beam");
  require_laws(masses_, "spring mass");
  body_.inertia = (0.5 * (body_.inertia + body_.inertia.transpose())).eval();
  rigid_ = MassProperties::body(body_.mass, body_.inertia);
  require_numbers(rigid_, spin_, "body");
  const auto add = [this](const MassProperties& part, const char* name, std::size_t i) {
    require_numbers(part, spin_, fmt::format("{} {}", name, i + 1));
    rigid_ += part;
    require_numbers(rigid_, spin_, fmt::format("{} {} with what comes before it", name, i + 1));
  };
  for (std::size_t i = 0; i < cables_.size(); ++i) add(CableGroup({cables_[i]}, spin_).rigid(), "cable", i);
  for (std::size_t i = 0; i < beams_.size(); ++i) add(BeamAppendage(beams_[i], spin_).rigid(), "beam", i);
  for (std::size_t i = 0; i < masses_.size(); ++i) add(MassProperties::point(masses_[i].mass, masses_[i].position), "spring mass", i);
  centre_ = rigid_.first(2) / rigid_.mass;
  require_equilibrium();
  rigid_ = rigid_.seen_from(centre_);
}

// docs/booms.md (B12): no net centrifugal force on the body, and no net moment across the spin axis.
void Spacecraft::require_equilibrium() const {
  const double square = spin_ * spin_;
  const double across = rigid_.first.head<2>().norm();
  if (across > tolerance * total_first_moment(*this)) {
    throw LawBroken(
        fmt::format("steady spin about axis 3 must be an equilibrium: the mass centre is off the axis by ({:.6g}, {:.6g}) m, which leaves "
                    "a centrifugal force of ({:.6g}, {:.6g}) N "
                    "(balance Σ S (cos α, sin α) + Σ m (x, y) = 0, S = ∫ r dm of each cable)",
                    rigid_.first(0) / rigid_.mass, rigid_.first(1) / rigid_.mass, square * rigid_.first(0), square * rigid_.first(1)));
  }
  const Eigen::Matrix3d j = rigid_.inertia();
  const double product = std::hypot(j(0, 2), j(1, 2));
  if (product > tolerance * j(2, 2)) {
    throw LawBroken(
        fmt::format("steady spin about axis 3 must be an equilibrium: the products of inertia of the complete satellite are J13 = {:.6g}, "
                    "J23 = {:.6g} kg m², which leaves a moment of "
                    "({:.6g}, {:.6g}) N m (the body's own J13 must be Σ S h cos α + Σ m x z, and J23 likewise with sin α and y)",
                    j(0, 2), j(1, 2), square * j(1, 2), -square * j(0, 2)));
  }
}

}  // namespace gyromode
