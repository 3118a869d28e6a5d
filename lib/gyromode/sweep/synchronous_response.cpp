#include "gyromode/sweep/synchronous_response.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/indefinite.h"
#include "gyromode/motion/driven_runs.h"
#include "gyromode/motion/driven_sweep.h"
#include "gyromode/sweep/critical_speeds.h"
#include "gyromode/sweep/family_structure.h"
#include "gyromode/sweep/quarter_turn.h"
#include "gyromode/structure/inertia_of_k.h"
#include "gyromode/system/scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

void require(const SpinSource& source, const SynchronousForce& force, const Vector& speeds) {
  if (!source.family)
    throw NotApplicable(
        "the response to unbalance needs a rotor, or matrices with 'spin' and 'gyroscopic_per_spin' or "
        "'stiffness_per_spin2'");
  if (force.per_speed2.size() != source.family->mass.rows())
    throw InvalidArgument(
        fmt::format("force: {} numbers where the model has {} coordinates", force.per_speed2.size(), source.family->mass.rows()));
  if (!force.per_speed2.allFinite() || !(force.order >= 0) || !std::isfinite(force.order))
    throw InvalidArgument("force and order must be finite, and the order ≥ 0");
  for (Index k = 0; k < speeds.size(); ++k) {
    if (!(speeds(k) >= 0) || !std::isfinite(speeds(k)) || (k > 0 && !(speeds(k) > speeds(k - 1))))
      throw InvalidArgument(fmt::format("speed {:.17g}: ascending speeds ≥ 0 were expected", speeds(k)));
  }
}

class Unbalanced {
 public:
  Unbalanced(const SpinFamily& family, const SynchronousForce& force) : family_(family), force_(force) {}

  ComplexVector solved(double speed) const {
    const SpinFamily::Sum sum = family_.sum(speed);
    const double omega = force_.order * speed;
    ComplexMatrix h(family_.mass.rows(), family_.mass.rows());
    h.real() = sum.stiffness - omega * omega * family_.mass;
    h.imag() = omega * sum.gyroscopic;
    const Vector d = equilibrating_scale(h);
    const ComplexMatrix right = d.cwiseProduct(speed * speed * force_.per_speed2);
    return d.asDiagonal() * lapack::solve(lapack::factor_indefinite(scaled(h, d)), right).col(0);
  }

  // From both sides of a critical speed that is not driven.
  ComplexVector limit(double speed) const {
    constexpr double beside = 1e-6;
    return 0.5 * (solved(speed * (1 + beside)) + solved(speed * (1 - beside)));
  }

  // Ω → 0: nothing moves, but for places that nothing holds.
  ComplexVector at_rest() const {
    constexpr double slow = 1e-6;
    if (inertia_of_k(family_.stiffness).zero == 0) return ComplexVector::Zero(family_.mass.rows());
    const double typical = std::sqrt(family_.stiffness.norm() / family_.mass.norm());
    return solved(slow * (typical > 0 ? typical : 1));
  }

 private:
  const SpinFamily& family_;
  const SynchronousForce& force_;
};

// What every critical speed has of the force, the parts of the model one by one.
std::vector<DrivenMode> met(const SpinSource& source, const SynchronousForce& force, const CriticalSpeeds& found) {
  constexpr double widest = 1e-7, pure = 1e-6;
  const SpinFamily& family = *source.family;
  const QuarterTurn turn(source.transverse);
  const std::optional<int> sense = turn.is_symmetry_of(family) ? turn.sense_of(force.per_speed2, 8 * epsilon) : std::nullopt;
  // The size of the force does not matter; a power of two keeps squares in range.
  const ComplexVector f = force.per_speed2 / power_of_two_near(force.per_speed2.cwiseAbs().maxCoeff());
  const auto squares = [&](double speed) -> Vector {
    return family.mass.diagonal() + family.stiffness.diagonal().cwiseAbs() / (speed * speed);
  };
  std::vector<DrivenMode> all;
  for (const Component& c : structure_of(family).components) {
    std::vector<PoleMet> poles;
    double typical = 0;
    for (const CriticalSpeed& s : found.speeds) {
      const ComplexVector x = s.shape(c.coordinates), own = f(c.coordinates);
      if (!(x.squaredNorm() > 0)) continue;
      const Vector d2 = squares(s.speed)(c.coordinates);
      const double whole2 = f.cwiseAbs2().cwiseQuotient(squares(s.speed)).sum();
      const bool other_way = sense && turn.sense_of(s.shape, pure) == -*sense;
      const bool reached = !other_way && x.cwiseAbs().dot(own.cwiseAbs()) > 0;
      const double work2 = std::norm(x.dot(own)) / (x.cwiseAbs2().dot(d2) * whole2);
      poles.push_back({s.speed, std::min(s.error_bound + 4 * epsilon * s.speed, widest * s.speed), other_way ? 0 : work2, reached});
      typical = s.speed;
    }
    if (poles.empty()) continue;
    const double whole2 = f.cwiseAbs2().cwiseQuotient(squares(typical)).sum(),
                 own2 = ComplexVector(f(c.coordinates)).cwiseAbs2().cwiseQuotient(Vector(squares(typical)(c.coordinates))).sum();
    const std::vector<DrivenMode> judgement = judged(poles, {std::sqrt(own2 / whole2), 1, static_cast<Index>(c.coordinates.size())});
    all.insert(all.end(), judgement.begin(), judgement.end());
  }
  std::stable_sort(all.begin(), all.end(), [](const DrivenMode& a, const DrivenMode& b) { return a.omega < b.omega; });
  return all;
}

CriticalSpeeds critical_below(const SpinFamily& family, double order, double highest) {
  CriticalOptions o;
  o.order = order;
  o.window.b = 2 * highest;  // those beyond say how far the last is from the next
  return critical_speeds(family, o);
}

}  // namespace

std::vector<double> SynchronousResponse::resonances() const {
  std::vector<double> all;
  for (const DrivenMode& m : critical) {
    if (m.driven == Driven::yes) all.push_back(m.omega);
  }
  return all;
}

SynchronousResponse synchronous_response(const SpinSource& source, const SynchronousForce& force, const Vector& speeds,
                                         const Progress& progress) {
  require(source, force, speeds);
  SynchronousResponse r;
  r.order = force.order;
  if (speeds.size() == 0) return r;
  const Unbalanced unbalanced(*source.family, force);
  DrivenSweep sweep;
  if (speeds(speeds.size() - 1) > 0 && force.per_speed2.squaredNorm() > 0) {
    const CriticalSpeeds found = critical_below(*source.family, force.order, speeds(speeds.size() - 1));
    r.coverage = found.coverage;
    sweep.poles = met(source, force, found);
    std::erase_if(sweep.poles,
                  [&](const DrivenMode& m) { return m.omega + m.error < speeds(0) || m.omega - m.error > speeds(speeds.size() - 1); });
  }
  sweep.solved = [&](double speed) { return speed > 0 ? unbalanced.solved(speed) : unbalanced.at_rest(); };
  sweep.limit = [&](double speed) { return unbalanced.limit(speed); };
  sweep.progress_of = "speeds";
  FrequencyResponse points = sweep.over(speeds, true, progress);
  r.critical = std::move(points.modes);
  r.interrupted = points.interrupted;
  for (FrequencyPoint& p : points.points) r.points.push_back({p.omega, std::move(p.q), p.driven, p.added, p.participation});
  return r;
}

}  // namespace gyromode
