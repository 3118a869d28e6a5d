#include "gyromode/modes/local_modes.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"
#include "gyromode/modes/shape.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace gyromode {

namespace {

constexpr double farthest_movement = 1e-8;
constexpr double worth_a_look = 1e-6;  // of b in an equilibrated shape of length 1: more is neither rest nor rounding, and is not looked at

// One step of inverse iteration on CᴴC, orthogonal after each half: the span of V and W turns to the smallest singular
// values of C. Of that, the part beside W.
ComplexMatrix turned_to_null(const ComplexMatrix& c, const ComplexMatrix& v, const ComplexMatrix& w) {
  ComplexMatrix both(v.rows(), v.cols() + w.cols());
  both << v, w;
  ComplexMatrix r = small::qr(c).r;
  const double least = epsilon * r.cwiseAbs().maxCoeff();
  for (Index i = 0; i < r.cols(); ++i) {
    if (!(std::abs(r(i, i)) > least)) r(i, i) = least;
  }
  const ComplexMatrix half = small::orthonormal_columns(ComplexMatrix(r.adjoint().triangularView<Eigen::Lower>().solve(both)));
  const ComplexMatrix turned = small::orthonormal_columns(ComplexMatrix(r.triangularView<Eigen::Upper>().solve(half)));
  if (w.cols() == 0) return turned;
  return turned * small::singular_value_decomposition(w.adjoint() * turned).v.rightCols(v.cols());
}

}  // namespace

struct ComponentSeenFrom::Scales {
  Vector whole;     // n: equilibrates all of |H|
  Vector internal;  // S
  Vector rows;      // R, n
};

// Vectors v = S ṽ with orthonormal ṽ, and what they are taken to.
struct ComponentSeenFrom::Subspace {
  ComplexMatrix v, k, g, m;  // n_i × p; K, jG, M times (0, v): n × p
  double smallest = 1;       // singular value of C̃ on it, where it was looked for last

  void turn(const ComplexMatrix& by) {
    for (ComplexMatrix* a : {&v, &k, &g, &m}) *a = (*a * by).eval();
  }
  ComplexMatrix image(double omega) const { return k + omega * g - omega * omega * m; }
  // vᴴ(2ωM − jG)v over all pairs.
  ComplexMatrix form(double omega) const {
    const Index n = v.rows();
    return v.adjoint() * (2 * omega * m.bottomRows(n) - g.bottomRows(n));
  }
  // The root of vᴴDv = 0 near ω, of the last column: at most three steps of Newton's method.
  double frequency(double omega) const {
    const auto of = [&](const ComplexMatrix& a) {
      return v.rightCols<1>().reshaped().dot(a.bottomRows(v.rows()).rightCols<1>().reshaped()).real();
    };
    const double a = of(k), b = of(g), c = of(m);
    for (int step = 0; step < 3; ++step) omega += (a + omega * (b - omega * c)) / (2 * omega * c - b);
    return omega;
  }
};

struct ComponentSeenFrom::Local {
  double omega;
  double form;
  ComplexVector shape;  // n, b first, with phases taken off
};

ComponentSeenFrom::ComponentSeenFrom(const System& system, const Component& component, const std::vector<Index>& kept) {
  const auto is_kept = [&](Index i) { return std::find(kept.begin(), kept.end(), i) != kept.end(); };
  order_ = component.coordinates;
  kept_ = std::stable_partition(order_.begin(), order_.end(), is_kept) - order_.begin();
  const Index n = static_cast<Index>(order_.size());
  phase_ = ComplexVector::Ones(n);
  for (Index i = 0; i < n; ++i) {
    const auto& crossed = component.in_quadrature;
    if (component.quadrature() && std::find(crossed.begin(), crossed.end(), order_[static_cast<std::size_t>(i)]) != crossed.end())
      phase_(i) = Complex(0, -1);
  }
  const auto turned = [&](const Matrix& a, Complex unit) -> ComplexMatrix {
    return phase_.conjugate().asDiagonal() * (unit * a(order_, order_)) * phase_.asDiagonal();
  };
  stiffness_ = turned(system.stiffness(), 1);
  gyroscopic_ = turned(system.gyroscopic(), Complex(0, 1));
  mass_ = turned(system.mass(), 1);
}

ComponentSeenFrom::Subspace ComponentSeenFrom::spanned(const Scales& s, const ComplexMatrix& basis) const {
  const ComplexMatrix v = s.internal.asDiagonal() * basis;
  return {v, internal_images(stiffness_, v), internal_images(gyroscopic_, v), internal_images(mass_, v), 1};
}

ComplexMatrix ComponentSeenFrom::internal_images(const ComplexMatrix& of, const ComplexMatrix& v) const {
  return of.rightCols(internal()) * v;
}

// C̃(ω), n × n_i.
ComplexMatrix ComponentSeenFrom::scaled_columns(const Scales& s, double omega) const {
  const Index n = internal();
  const ComplexMatrix c = stiffness_.rightCols(n) + omega * gyroscopic_.rightCols(n) - omega * omega * mass_.rightCols(n);
  return s.rows.asDiagonal() * c * s.internal.asDiagonal();
}

// The local modes of `v` next to ω, taken out of it; ω follows the smallest singular value to its root.
std::vector<ComponentSeenFrom::Local> ComponentSeenFrom::take_null_vectors(const Scales& s, Subspace& v, double& omega) const {
  const auto decompose = [&](double at) { return small::right_singular(s.rows.asDiagonal() * v.image(at)); };
  const double from = omega;
  for (int step = 0; step < 2; ++step) {
    v.turn(decompose(omega).v);
    const double next = v.frequency(omega);
    if (!(std::abs(next - from) <= worth_a_look * from)) return {};  // of another mode
    omega = next;
  }
  const small::Svd last = decompose(omega);
  v.turn(last.v);
  v.smallest = last.values.minCoeff();
  const double limit = solver_residual(static_cast<Index>(order_.size()));
  const Index nullity = (last.values.array() <= limit).count(), rest = v.v.cols() - nullity;
  if (nullity == 0) return {};
  const double unexplained = last.values(rest) + epsilon * static_cast<double>(order_.size());
  Subspace null{v.v.rightCols(nullity), v.k.rightCols(nullity), v.g.rightCols(nullity), v.m.rightCols(nullity), 0};
  v = {v.v.leftCols(rest).eval(), v.k.leftCols(rest).eval(), v.g.leftCols(rest).eval(), v.m.leftCols(rest).eval(), 1};
  const auto forms = small::hermitian_eigen(null.form(omega));
  null.turn(forms.vectors);
  std::vector<Local> found;
  for (Index k = 0; k < nullity; ++k) {
    if (!(unexplained <= farthest_movement * omega * std::abs(forms.values(k)))) continue;
    ComplexVector x = ComplexVector::Zero(static_cast<Index>(order_.size()));
    x.tail(internal()) = null.v.col(k);
    found.push_back({omega, forms.values(k), std::move(x)});
  }
  return found;
}

// Candidates are the combinations of the shapes that leave b at rest as far as shapes can tell, all of them where the
// modes are not known well; C̃ decides.
std::vector<ComponentSeenFrom::Local> ComponentSeenFrom::locals(const Scales& s, const ComplexMatrix& shapes,
                                                                const std::vector<Mode*>& near) const {
  const small::Svd svd = small::singular_value_decomposition(shapes.topRows(kept_));
  const bool trusted = std::all_of(near.begin(), near.end(), [](const Mode* m) { return m->error_bound <= farthest_movement * m->omega; });
  const Index resting = shapes.cols() - (trusted ? (svd.values.array() > worth_a_look).count() : 0);
  if (resting == 0) return {};
  const ComplexMatrix inside = s.whole.tail(internal()).asDiagonal() * (shapes.bottomRows(internal()) * svd.v.rightCols(resting));
  const ComplexMatrix basis = small::orthonormal_columns(ComplexMatrix(s.internal.cwiseInverse().asDiagonal() * inside));
  Subspace v = spanned(s, basis);
  ComplexMatrix taken(internal(), 0);
  std::vector<Local> all;
  for (const Mode* m : near) {
    if (v.v.cols() == 0) break;
    double omega = m->omega;
    std::vector<Local> found = take_null_vectors(s, v, omega);
    Subspace better = v;
    // the shapes may hold others that are almost at the same frequency
    for (int step = 0; step < 2 && found.empty() && v.v.cols() > 0; ++step) {
      const ComplexMatrix unscaled = s.internal.cwiseInverse().asDiagonal() * better.v;
      better = spanned(s, turned_to_null(scaled_columns(s, omega), unscaled, taken));
      found = take_null_vectors(s, better, omega);
      if (!found.empty())
        v = better;
      else if (!(better.smallest <= worth_a_look))
        break;
    }
    for (const Local& y : found) {
      taken.conservativeResize(Eigen::NoChange, taken.cols() + 1);
      taken.rightCols<1>() = (s.internal.cwiseInverse().asDiagonal() * y.shape.tail(internal())).normalized();
    }
    std::move(found.begin(), found.end(), std::back_inserter(all));
  }
  std::sort(all.begin(), all.end(), [](const Local& a, const Local& b) { return a.omega < b.omega; });
  return all;
}

// x − Σ y (yᴴ((ω + ω_y)M − jG)x) / (yᴴ(2ω_yM − jG)y).
ComplexVector ComponentSeenFrom::conjugate_part(const ComplexVector& x, double omega, const std::vector<Local>& to) const {
  const ComplexVector m = mass_ * x, g = gyroscopic_ * x;
  ComplexVector rest = x;
  for (const Local& y : to) rest -= y.shape * (y.shape.dot((omega + y.omega) * m - g) / y.form);
  return rest;
}

ComplexVector ComponentSeenFrom::in_system(const ComplexVector& x, Index n) const {
  ComplexVector whole = ComplexVector::Zero(n);
  whole(order_) = phase_.cwiseProduct(x);
  return normalised(std::move(whole));
}

// Of the modes of one energy sign as many become local as there are local modes of that sign: those whose shapes keep
// least beside the local ones.
void ComponentSeenFrom::assign(const Scales& s, const ComplexMatrix& shapes, const std::vector<Mode*>& modes,
                               const std::vector<Local>& mine, const std::vector<Local>& all) const {
  ComplexMatrix beside(shapes.rows(), shapes.cols());
  for (Index k = 0; k < shapes.cols(); ++k) {
    const ComplexVector x = s.whole.asDiagonal() * shapes.col(k);
    beside.col(k) = s.whole.cwiseInverse().asDiagonal() * conjugate_part(x, modes[static_cast<std::size_t>(k)]->omega, all);
  }
  const std::vector<Index> order = small::largest_columns_first(beside);
  const Index others = shapes.cols() - static_cast<Index>(mine.size());
  for (Index k = 0; k < others; ++k) {
    Mode& m = *modes[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])];
    const auto rest = beside.col(order[static_cast<std::size_t>(k)]);
    if (rest.norm() > worth_a_look) m.shape = in_system(s.whole.asDiagonal() * rest, m.shape.size());
  }
  std::vector<Index> places(order.begin() + others, order.end());
  std::sort(places.begin(), places.end());
  for (std::size_t k = 0; k < mine.size(); ++k) {
    Mode& m = *modes[static_cast<std::size_t>(places[k])];
    m.kind = ModeKind::local;
    m.shape = in_system(mine[k].shape, m.shape.size());
  }
}

ComponentSeenFrom::Scales ComponentSeenFrom::scales(double omega) const {
  const Matrix size = stiffness_.cwiseAbs() + omega * gyroscopic_.cwiseAbs() + omega * omega * mass_.cwiseAbs();
  Scales s{equilibrating_scale(size), equilibrating_scale(Matrix(size.bottomRightCorner(internal(), internal()))),
           Vector::Zero(size.rows())};
  const Vector largest = (size.topRightCorner(kept_, internal()) * s.internal.asDiagonal()).rowwise().maxCoeff();
  for (Index i = 0; i < kept_; ++i) s.rows(i) = largest(i) > 0 ? 1 / largest(i) : 0;
  s.rows.tail(internal()) = s.internal;
  return s;
}

void ComponentSeenFrom::mark_local(const std::vector<Mode*>& near) const {
  const Scales s = scales(near.front()->omega);
  ComplexMatrix shapes(static_cast<Index>(order_.size()), static_cast<Index>(near.size()));
  for (std::size_t k = 0; k < near.size(); ++k) {
    const ComplexVector x = normalised(phase_.conjugate().cwiseProduct(near[k]->shape(order_)));
    shapes.col(static_cast<Index>(k)) = (s.whole.cwiseInverse().asDiagonal() * x).normalized();
  }
  const std::vector<Local> all = locals(s, shapes, near);
  std::vector<Local> left = all;
  for (const int sign : {1, -1, 0}) {  // undecided modes take what the decided ones leave
    std::vector<Index> columns;
    std::vector<Mode*> modes;
    for (std::size_t k = 0; k < near.size(); ++k) {
      if (near[k]->energy_sign != sign) continue;
      columns.push_back(static_cast<Index>(k));
      modes.push_back(near[k]);
    }
    const auto fits = [&](const Local& y) { return sign == 0 || y.form * sign > 0; };
    std::vector<Local> mine, rest;
    for (const Local& y : left) (fits(y) && mine.size() < modes.size() ? mine : rest).push_back(y);
    left = rest;
    if (!all.empty() && !modes.empty()) assign(s, shapes(Eigen::all, columns), modes, mine, all);
  }
}

}  // namespace gyromode
