#include "gyromode/modes/repair_effects.h"

#include "gyromode/lapack/small.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode {

namespace {

// All roots λ ≠ 0 of a system of second order, of both signs, or all roots of one of first order.
struct Roots {
  ComplexVector lambda;
  ComplexMatrix right, left;
  ComplexVector slope;
  std::vector<Index> mode;  // the position in the list of oscillations that a root stands for; −1: none that is listed by itself

  Index count() const { return lambda.size(); }
};

class RootList {
 public:
  void add(Complex lambda, ComplexVector x, ComplexVector y, Complex slope, Index mode) {
    lambda_.push_back(lambda);
    slope_.push_back(slope);
    right_.push_back(std::move(x));
    left_.push_back(std::move(y));
    mode_.push_back(mode);
  }
  Roots joined(Index n) const {
    const Index count = static_cast<Index>(lambda_.size());
    Roots r{ComplexVector(count), ComplexMatrix(n, count), ComplexMatrix(n, count), ComplexVector(count), mode_};
    for (std::size_t k = 0; k < lambda_.size(); ++k) {
      const Index at = static_cast<Index>(k);
      r.lambda(at) = lambda_[k];
      r.slope(at) = slope_[k];
      r.right.col(at) = right_[k];
      r.left.col(at) = left_[k];
    }
    return r;
  }

 private:
  std::vector<Complex> lambda_, slope_;
  std::vector<ComplexVector> right_, left_;
  std::vector<Index> mode_;
};

// An oscillation and its conjugate: N(jω) = H(ω) is Hermitian, so that y = x, and the slope is j times the form.
void add_oscillation(RootList& to, const Mode& m, Index at) {
  const Complex j(0, 1);
  to.add(j * m.omega, m.shape, m.shape, j * m.form, at);
  to.add(-j * m.omega, m.shape.conjugate(), m.shape.conjugate(), -j * m.form, -1);
}

// λ, λ̄, −λ̄, −λ: the left vector of one is the right vector of its mirror image in the imaginary axis.
void add_growing(RootList& to, const System& s, Complex lambda, const ComplexVector& x, const ComplexVector& y) {
  const Complex slope = y.dot((2.0 * lambda) * (s.mass() * x) + s.gyroscopic() * x);
  const Complex mirrored = x.dot((-2.0 * std::conj(lambda)) * (s.mass() * y) + s.gyroscopic() * y);
  to.add(lambda, x, y, slope, -1);
  to.add(-std::conj(lambda), y, x, mirrored, -1);
  if (lambda.imag() == 0) return;
  to.add(std::conj(lambda), x.conjugate(), y.conjugate(), std::conj(slope), -1);
  to.add(-lambda, y.conjugate(), x.conjugate(), std::conj(mirrored), -1);
}

// λᵖ·(−dropped) is what the repair changed in N(λ): p = 2, 1, 0 for M, G, K; 1, 0 for I, G of first order.
Complex power(const std::string& matrix, bool first_order, Complex lambda) {
  if (matrix == "M") return lambda * lambda;
  if (matrix == "I" || (matrix == "G" && !first_order)) return lambda;
  return 1;
}

// The eigenvalues of diag(λ_k − λ₀) + B of a few roots, against λ_k − λ₀: the largest distance, paired in order.
double moved(const ComplexVector& lambda, const ComplexMatrix& b) {
  const Complex centre = lambda.mean();
  const ComplexVector before = lambda.array() - centre;
  const ComplexVector after = small::schur(ComplexMatrix(before.asDiagonal()) + b).t.diagonal();
  const auto in_order = [](const ComplexVector& z) {
    std::vector<Complex> all(z.begin(), z.end());
    std::sort(all.begin(), all.end(), [](Complex p, Complex q) { return p.imag() < q.imag(); });
    return all;
  };
  const auto p = in_order(before), q = in_order(after);
  double most = 0;
  for (std::size_t k = 0; k < p.size(); ++k) most = std::max(most, std::abs(p[k] - q[k]));
  return most;
}

struct Effect {
  double size = 0, omega = 0, error_bound = 0;

  void take(double moved_by, double at, double bound) {
    if (moved_by > size) *this = {moved_by, at, bound};
  }
};

// The dropped part between all roots, C_kl = y_kᴴ D x_l, and what it does to each.
class Perturbation {
 public:
  Perturbation(const Roots& roots, const Repair& repair, bool first_order)
      : roots_(roots), repair_(repair), first_order_(first_order), between_(roots.left.adjoint() * (*repair.dropped * roots.right)) {}

  // B_kl at the root i.
  Complex b(Index k, Index l, Index i) const {
    return -power(repair_.matrix, first_order_, roots_.lambda(i)) * between_(k, l) / roots_.slope(k);
  }

  // Root i with those that B brings to it, as a block; the others in second order; what the zero modes add to it.
  double effect_on(Index i, Complex by_zero_modes) const {
    std::vector<Index> near{i};
    Complex far = by_zero_modes;
    for (Index k = 0; k < roots_.count(); ++k) {
      if (k == i) continue;
      const Complex product = b(i, k, i) * b(k, i, i), distance = roots_.lambda(i) - roots_.lambda(k);
      if (std::norm(distance) <= 400 * std::abs(product) || std::abs(distance) <= 20 * (std::abs(b(i, i, i)) + std::abs(b(k, k, i)))) {
        near.push_back(k);
      } else {
        far += product / distance;
      }
    }
    if (near.size() == 1) return std::abs(b(i, i, i) + far);
    const Index count = static_cast<Index>(near.size());
    ComplexMatrix block(count, count);
    for (Index k = 0; k < count; ++k) {
      for (Index l = 0; l < count; ++l) block(k, l) = b(near[static_cast<std::size_t>(k)], near[static_cast<std::size_t>(l)], i);
    }
    return moved(roots_.lambda(near), block) + std::abs(far);
  }

 private:
  const Roots& roots_;
  const Repair& repair_;
  bool first_order_;
  ComplexMatrix between_;
};

// Zero modes Z of a system of second order: λ²F + ZᵀδKZ − (ZᵀδK) R (δK Z) = 0, or λF + ZᵀδGZ = 0, with F = Zᵀ(M +
// GᵀRG)Z, R what all other roots leave of K⁻¹: Σ x_k y_kᴴ / (−λ_k d_k).
class ZeroModes {
 public:
  ZeroModes(const System& s, const Roots& roots, const Matrix& shapes) : z_(shapes) {
    if (z_.cols() == 0) return;
    const ComplexVector weights = (-roots.lambda.array() * roots.slope.array()).inverse();
    compliance_ = (roots.right * weights.asDiagonal() * roots.left.adjoint()).real();
    const Matrix image = s.gyroscopic() * z_;
    inertia_ = z_.transpose() * s.mass() * z_ + image.transpose() * compliance_ * image;
  }

  double effect_of(const Repair& r) const {
    const Index n = z_.cols();
    if (n == 0 || r.matrix == "M") return 0;
    const Matrix image = *r.dropped * z_;
    const Matrix seen = z_.transpose() * image;
    if (r.matrix == "G") return small::eigenvalues(small::solve(inertia_, seen)).cwiseAbs().maxCoeff();
    const Matrix stiffness = seen + image.transpose() * compliance_ * image;  // δKᵀ = −δK
    return std::sqrt(small::eigenvalues(small::solve(inertia_, stiffness)).cwiseAbs().maxCoeff());
  }

  // −XᴴD Z F⁻¹ ZᵀD X / (λ²·slope): the zero modes' part of the second order.
  Complex on(const Repair& r, Complex lambda, const ComplexVector& x, Complex slope, Complex factor) const {
    if (z_.cols() == 0) return 0;
    const ComplexVector right = z_.transpose() * (*r.dropped * x), left = z_.transpose() * (r.dropped->transpose() * x.conjugate());
    const ComplexVector solved = small::solve(inertia_, Matrix(right.real())).cast<Complex>() +
                                 Complex(0, 1) * small::solve(inertia_, Matrix(right.imag())).cast<Complex>();
    return factor * factor * left.cwiseProduct(solved).sum() / (lambda * lambda * slope);
  }

 private:
  Matrix z_, compliance_, inertia_;
};

Roots roots_of(const System& s, const std::vector<Mode>& oscillations, const UnstableRoots& unstable) {
  RootList list;
  for (std::size_t k = 0; k < oscillations.size(); ++k) add_oscillation(list, oscillations[k], static_cast<Index>(k));
  for (Index k = 0; k < unstable.count(); ++k)
    add_growing(list, s, unstable.lambda[static_cast<std::size_t>(k)], unstable.right.col(k), unstable.left.col(k));
  return list.joined(s.size());
}

Roots roots_of(const FirstOrderSystem& s, const std::vector<Mode>& oscillations, const Matrix& zero) {
  RootList list;
  const Complex j(0, 1);
  for (std::size_t k = 0; k < oscillations.size(); ++k) {
    const Mode& m = oscillations[k];
    list.add(j * m.omega, m.shape, m.shape, m.form, static_cast<Index>(k));
    list.add(-j * m.omega, m.shape.conjugate(), m.shape.conjugate(), m.form, -1);
  }
  for (Index k = 0; k < zero.cols(); ++k) {
    const ComplexVector x = zero.col(k).cast<Complex>();
    list.add(0, x, x, x.dot(s.inertia() * x), -1);
  }
  return list.joined(s.size());
}

bool lists_zero_modes(const ModesResult& r) {
  return std::any_of(r.modes.begin(), r.modes.end(), [](const Mode& m) { return m.omega == 0; });
}

void store(Repair& r, const Effect& e) {
  r.largest_effect = 1.001 * e.size;  // the orders left out are less than that
  r.effect_at = e.omega;
  r.error_bound = e.error_bound;
}

}  // namespace

void state_effects(const System& system, const MatrixSpectrum& spectrum, ModesResult& result) {
  const std::vector<Mode> oscillations = spectrum.oscillations();
  const Roots roots = roots_of(system, oscillations, spectrum.unstable());
  const ZeroModes zero(system, roots, spectrum.zero_shapes());
  for (Repair& r : result.repairs) {
    const Perturbation p(roots, r, false);
    Effect effect;
    if (lists_zero_modes(result)) effect.take(zero.effect_of(r), 0, 0);
    for (Index i = 0; i < roots.count(); ++i) {
      const Complex lambda = roots.lambda(i);
      const Index at = roots.mode[static_cast<std::size_t>(i)];
      const Mode* m = at < 0 ? nullptr : &oscillations[static_cast<std::size_t>(at)];
      if (m ? !result.coverage.window.contains(m->omega) : !(lambda.real() > 0 && lambda.imag() >= 0)) continue;
      const Complex by_zero = m ? zero.on(r, lambda, m->shape, roots.slope(i), power(r.matrix, false, lambda)) : Complex(0);
      effect.take(p.effect_on(i, by_zero), lambda.imag(), m ? m->error_bound : 0);
    }
    store(r, effect);
  }
}

void state_effects(const FirstOrderSystem& system, const MatrixSpectrum& spectrum, ModesResult& result) {
  const std::vector<Mode> oscillations = spectrum.oscillations();
  const Roots roots = roots_of(system, oscillations, spectrum.zero_shapes());
  for (Repair& r : result.repairs) {
    const Perturbation p(roots, r, true);
    Effect effect;
    for (Index i = 0; i < roots.count(); ++i) {
      const Index at = roots.mode[static_cast<std::size_t>(i)];
      const double omega = roots.lambda(i).imag();
      if (omega < 0 || !result.coverage.window.contains(omega)) continue;
      effect.take(p.effect_on(i, 0), omega, at < 0 ? 0 : oscillations[static_cast<std::size_t>(at)].error_bound);
    }
    store(r, effect);
  }
}

}  // namespace gyromode
