#include "gyromode/sweep/spin_sampler.h"

#include "gyromode/base/parallel.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"
#include "gyromode/modes/shape.h"
#include "gyromode/sweep/quadrature_axes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace gyromode {

namespace {

// Frequencies nearer than this may share their shapes with each other by rounding.
constexpr double shared = 1e-6;

ComplexMatrix times(const Matrix& a, const ComplexMatrix& x) {
  if (a.size() == 0) return ComplexMatrix::Zero(x.rows(), x.cols());
  return (a * x.real()).cast<Complex>() + imaginary_unit * (a * x.imag()).cast<Complex>();
}

// What a family has at one place (ω, Ω), applied to shapes.
struct Place {
  const SpinFamily& f;
  double spin, omega;

  ComplexMatrix gyroscopic(const ComplexMatrix& x) const { return times(f.gyroscopic, x) + spin * times(f.gyroscopic_per_spin, x); }
  /// H X
  ComplexMatrix impedance(const ComplexMatrix& x) const {
    return times(f.stiffness, x) + spin * spin * times(f.stiffness_per_spin2, x) + (imaginary_unit * omega) * gyroscopic(x) -
           omega * omega * times(f.mass, x);
  }
  /// ∂H/∂Ω X
  ComplexMatrix by_spin(const ComplexMatrix& x) const {
    return 2 * spin * times(f.stiffness_per_spin2, x) + (imaginary_unit * omega) * times(f.gyroscopic_per_spin, x);
  }
  /// −∂H/∂ω X = (2ωM − jG) X
  ComplexMatrix form(const ComplexMatrix& x) const { return 2 * omega * times(f.mass, x) - imaginary_unit * gyroscopic(x); }
};

// Shapes of one block among those of one frequency, made those of single roots: ω + δ with (XᴴHX) c = δ (Xᴴ(2ωM − jG)X)
// c.
struct Turned {
  Vector by;
  ComplexMatrix shapes;
};
Turned roots_among(const Place& at, const ComplexMatrix& x) {
  const ComplexMatrix h = x.adjoint() * at.impedance(x), f = x.adjoint() * at.form(x);
  const auto e = small::hermitian_eigen(ComplexMatrix(0.5 * (f + f.adjoint())));
  const double sign = e.values.sum() < 0 ? -1 : 1;
  if (!((sign * e.values).minCoeff() > 0)) return {Vector::Zero(x.cols()), x};  // of both signs: as they are
  const ComplexMatrix unit = e.vectors * (sign * e.values).cwiseSqrt().cwiseInverse().asDiagonal();
  const ComplexMatrix in_unit = unit.adjoint() * h * unit;
  const auto d = small::hermitian_eigen(ComplexMatrix((0.5 * sign) * (in_unit + in_unit.adjoint())));
  return {d.values, x * (unit * d.vectors)};
}

// A double mode of one block, or at rest of any, moves along any line and round either way.
void mark_degenerate(double spin, std::vector<SampledMode>& modes) {
  for (SampledMode& m : modes) {
    const bool other = std::any_of(modes.begin(), modes.end(), [&](const SampledMode& o) {
      return &o != &m && (spin == 0 || o.block == m.block) && std::abs(o.omega - m.omega) <= 4 * (o.error + m.error);
    });
    if (m.whirl && other) m.whirl = Whirl::degenerate;
  }
}

ModesOptions options_for(const SampledModes& wanted) {
  ModesOptions o;
  o.window.b = wanted.below;
  o.lowest = wanted.lowest;
  o.shapes = true;
  return o;
}

double highest_of(const ModesResult& result) {
  return result.modes.empty() || result.modes.back().omega == 0 ? 1 : result.modes.back().omega;
}

}  // namespace

SpinSampler::SpinSampler(SpinSource source, SampledModes wanted, double first, double last) : source_(std::move(source)), wanted_(wanted) {
  constexpr Index large = 48;
  if (!source_.family) return;
  const bool bounded = wanted_.lowest || std::isfinite(wanted_.below);
  if (source_.family->mass.rows() >= large && bounded && !source_.projected) {
    reduce(first, last);
    return;
  }
  double reach = wanted_.below;
  if (!std::isfinite(reach)) reach = highest_of(source_.modes(0.5 * (first + last), options_for(wanted_)));
  constexpr double noise = 1e-8;  // of shapes, in a projection on them
  blocks_.emplace(*source_.family, reach, source_.projected ? noise : 0);
}

// Spins are solved until the space of their shapes serves half way between every two of them.
void SpinSampler::reduce(double first, double last) {
  constexpr int first_spins = 3, most_spins = 17;
  constexpr Index more_modes = 4;
  constexpr double farther = 1.2, worth_it = 0.6;  // orders of the reduced matrices over that of the family
  const SampledModes around{farther * wanted_.below, wanted_.lowest ? std::optional(*wanted_.lowest + more_modes) : std::nullopt};
  std::vector<double> spins;
  for (int k = 0; k < first_spins; ++k) spins.push_back(first + (last - first) * k / (first_spins - 1));
  std::map<double, SpinSample> samples;
  while (true) {
    std::vector<double> missing;
    std::copy_if(spins.begin(), spins.end(), std::back_inserter(missing), [&](double s) { return !samples.contains(s); });
    std::vector<ModesResult> found(missing.size());
    for_each_in_parallel(static_cast<Index>(missing.size()), [&](Index k) {
      found[static_cast<std::size_t>(k)] = source_.modes(missing[static_cast<std::size_t>(k)], options_for(around));
    });
    if (!blocks_) blocks_.emplace(*source_.family, highest_of(found[found.size() / 2]));
    for (std::size_t k = 0; k < missing.size(); ++k) samples.insert_or_assign(missing[k], sample_of(missing[k], found[k]));
    std::vector<SpinSample> all;
    for (const auto& [spin, sample] : samples) all.push_back(sample);
    reduced_ = ReducedFamily::from(*source_.family, *blocks_, all, source_.places);
    if (!reduced_ || static_cast<double>(reduced_->order()) > worth_it * static_cast<double>(source_.family->mass.rows())) {
      reduced_.reset();
      return;
    }
    if (static_cast<int>(spins.size()) >= most_spins) return;
    std::vector<double> more;
    for (auto s = samples.begin(); std::next(s) != samples.end(); ++s) {
      const double middle = 0.5 * (s->first + std::next(s)->first);
      if (!reduced_->at(middle, wanted_.below, wanted_.lowest)) more.push_back(middle);
    }
    if (more.empty()) return;
    spins.insert(spins.end(), more.begin(), more.end());
  }
}

ComplexMatrix SpinSampler::impedance_slope(double omega, double spin) const {
  const double step = 1e-5 * std::abs(spin);
  return (source_.impedance(omega, spin + step) - source_.impedance(omega, spin - step)) / (2 * step);
}

// Of a model that is no family: a component of the body, or, the body at rest, a boom and the way it moves.
Index SpinSampler::block_by_coordinates(const Structure& structure, const Mode& mode) const {
  Index place = 0;
  const auto components = static_cast<Index>(structure.components.size());
  if (mode.kind != ModeKind::local && mode.shape.size() > 0 && mode.shape.cwiseAbs().maxCoeff(&place) > 0) {
    for (Index c = 0; c < components; ++c) {
      const auto& of = structure.components[static_cast<std::size_t>(c)].coordinates;
      if (std::binary_search(of.begin(), of.end(), place)) return c;
    }
  }
  constexpr double first_of_ties = 0.99;
  double most = 0;
  Index boom = 0, across = 0;
  for (std::size_t k = 0; k < mode.field.size(); ++k) {
    if (mode.field[k].size() == 0) continue;
    const double size = mode.field[k].cwiseAbs().maxCoeff();
    if (size * first_of_ties <= most) continue;
    most = size;
    boom = static_cast<Index>(k);
    across = mode.field[k].row(2).cwiseAbs().maxCoeff() > 0.5 * size ? 1 : 0;
  }
  return components + 2 * boom + across;
}

SampledMode SpinSampler::sampled(double spin, double omega, const Mode& mode, const ComplexVector& shape) const {
  SampledMode s;
  s.omega = omega;
  s.error = mode.error_bound;
  s.energy_sign = mode.energy_sign;
  s.multiplicity = mode.multiplicity;
  s.shape = normalised(shape);
  const ComplexVector seen = source_.seen ? source_.seen(s.shape) : s.shape;
  s.whirl = whirl_of(seen, source_.places, spin);
  s.fixed_axes = in_fixed_axes(seen, omega, spin, source_.places);
  if (source_.family) {
    const Place at{*source_.family, spin, omega};
    const double form = std::real(s.shape.dot(at.form(s.shape).col(0)));
    if (form != 0) s.slope = std::real(s.shape.dot(at.by_spin(s.shape).col(0))) / form;
    if (s.energy_sign == 0 && form != 0) s.energy_sign = form > 0 ? 1 : -1;
  } else if (source_.impedance && mode.kind != ModeKind::local && spin != 0) {
    const double step = 1e-5 * omega;
    const ComplexMatrix by_omega = (source_.impedance(omega + step, spin) - source_.impedance(omega - step, spin)) / (2 * step);
    const double form = std::real(s.shape.dot(by_omega * s.shape));
    if (form != 0 && std::isfinite(form)) s.slope = -std::real(s.shape.dot(impedance_slope(omega, spin) * s.shape)) / form;
  }
  return s;
}

// Modes of (nearly) one frequency, whose shapes may be any combination of the true ones: those with one block each.
void SpinSampler::separate(double spin, const std::vector<const Mode*>& cluster, SpinSample& to) const {
  ComplexMatrix shapes(cluster.front()->shape.size(), static_cast<Index>(cluster.size()));
  for (std::size_t k = 0; k < cluster.size(); ++k) shapes.col(static_cast<Index>(k)) = cluster[k]->shape;
  const Place at{*source_.family, spin, cluster.front()->omega};
  const ComplexMatrix pure = blocks_->separated(shapes);
  std::vector<std::vector<Index>> columns(static_cast<std::size_t>(blocks_->count()) + 1);
  for (Index k = 0; k < pure.cols(); ++k)
    columns[static_cast<std::size_t>(blocks_->block_of(pure.col(k)).value_or(blocks_->count()))].push_back(k);
  for (std::size_t b = 0; b < columns.size(); ++b) {
    if (columns[b].empty()) continue;
    const Turned roots = roots_among(at, pure(Eigen::all, columns[b]));
    for (Index k = 0; k < roots.by.size(); ++k) {
      SampledMode s = sampled(spin, at.omega + roots.by(k), *cluster.front(), roots.shapes.col(k));
      for (const Mode* m : cluster) s.error = std::max(s.error, m->error_bound);
      s.block = static_cast<Index>(b) < blocks_->count() ? static_cast<Index>(b) : -1;
      to.modes.push_back(std::move(s));
    }
  }
}

SpinSample SpinSampler::at(double spin) const {
  if (reduced_) {
    if (auto sample = reduced_->at(spin, wanted_.below, wanted_.lowest)) {
      mark_degenerate(spin, sample->modes);
      return std::move(*sample);
    }
  }
  return sample_of(spin, source_.modes(spin, options_for(wanted_)));
}

SpinSample SpinSampler::sample_of(double spin, const ModesResult& result) const {
  SpinSample sample;
  sample.spin = spin;
  sample.coverage = result.coverage;
  sample.stability = result.stability;
  sample.balance = result.index_balance;
  sample.unstable = result.unstable;
  std::vector<const Mode*> all;
  for (const Mode& m : result.modes) {
    if (m.kind != ModeKind::rigid_body && m.omega > 0) all.push_back(&m);
  }
  for (std::size_t first = 0, past; first < all.size(); first = past) {
    past = first + 1;
    while (past < all.size() && all[past]->omega - all[past - 1]->omega <= shared * all[past]->omega) ++past;
    const std::vector<const Mode*> cluster(all.begin() + static_cast<std::ptrdiff_t>(first),
                                           all.begin() + static_cast<std::ptrdiff_t>(past));
    const bool pure = !blocks_ || std::all_of(cluster.begin(), cluster.end(), [&](const Mode* m) { return blocks_->is_pure(m->shape); });
    if (!pure && cluster.size() > 1) {
      separate(spin, cluster, sample);
      continue;
    }
    for (const Mode* m : cluster) {
      SampledMode s = sampled(spin, m->omega, *m, m->shape);
      s.block = blocks_ ? blocks_->block_of(m->shape).value_or(-1) : block_by_coordinates(result.structure, *m);
      sample.modes.push_back(std::move(s));
    }
  }
  mark_degenerate(spin, sample.modes);
  std::stable_sort(sample.modes.begin(), sample.modes.end(), [](const SampledMode& a, const SampledMode& b) { return a.omega < b.omega; });
  return sample;
}

}  // namespace gyromode
