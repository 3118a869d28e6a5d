#include "gyromode/modes/repair_effects.h"

#include "gyromode/lapack/small.h"
#include "gyromode/modes/perturbation.h"
#include "gyromode/modes/root_vectors.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace gyromode {

namespace {

struct Effect {
  double size = 0, omega = 0, error_bound = 0;

  void take(double moved_by, double at, double bound) {
    if (moved_by > size) *this = {moved_by, at, bound};
  }
};

// Zero modes Z of a system of second order: λ²F + ZᵀδKZ − (ZᵀδK) R (δK Z) = 0, or λF + ZᵀδGZ = 0, with F = Zᵀ(M +
// GᵀRG)Z, R what all other roots leave of K⁻¹. `DZ` are the dropped part's products with them.
class ZeroModes {
 public:
  /// `roots` may be those of a whole with massless coordinates; F is that of the system alone, too.
  ZeroModes(const System& s, const RootVectors& of_system, const RootVectors& roots, const Matrix& shapes) : roots_(roots), z_(shapes) {
    if (const Condensation* whole = roots.whole()) {
      z_.resize(static_cast<Index>(whole->labels.size()), shapes.cols());
      for (Index k = 0; k < shapes.cols(); ++k) z_.col(k) = whole->expanded(0, shapes.col(k).cast<Complex>()).real();
    }
    if (none()) return;
    const Matrix image = s.gyroscopic() * shapes;
    inertia_ = shapes.transpose() * s.mass() * shapes + image.transpose() * of_system.compliance_times(image);
  }

  bool none() const { return z_.cols() == 0; }
  Matrix dropped(const Repair& r) const { return *r.dropped * z_; }

  double effect_of(const Repair& r, const Matrix& dz) const {
    if (none() || r.matrix == "M") return 0;
    const Matrix seen = z_.transpose() * dz;
    if (r.matrix == "G") return small::eigenvalues(small::solve(inertia_, seen)).cwiseAbs().maxCoeff();
    const Matrix stiffness = seen + dz.transpose() * roots_.compliance_times(dz);  // δKᵀ = −δK
    return std::sqrt(small::eigenvalues(small::solve(inertia_, stiffness)).cwiseAbs().maxCoeff());
  }

  // −xᴴΔ Z F⁻¹ ZᵀΔ x / (λ²·slope): their part of the second order, of an oscillation; ZᵀD = ±(DZ)ᵀ.
  Complex on(const Repair& r, const Matrix& dz, Complex lambda, const ComplexVector& x, Complex slope, Complex power) const {
    if (none()) return 0;
    const Matrix re = dz.transpose() * x.real(), im = dz.transpose() * x.imag();
    const Complex j(0, 1);
    const ComplexVector left = re.cast<Complex>() - j * im.cast<Complex>();  // (xᴴD Z)ᵀ
    const double parity = r.matrix == "G" ? 1 : -1;
    const ComplexVector solved = small::solve(inertia_, re).cast<Complex>() + j * small::solve(inertia_, im).cast<Complex>();
    return parity * power * power * left.cwiseProduct(solved).sum() / (lambda * lambda * slope);
  }

 private:
  const RootVectors& roots_;
  Matrix z_, inertia_;
};

// Oscillations of the window, growing motions with ω ≥ 0; zero roots of first order where the window holds 0.
std::vector<Index> listed_roots(const RootVectors& roots, const std::vector<Mode>& oscillations, const ModesResult& result) {
  std::vector<Index> listed;
  const Window& window = result.coverage.window;
  for (Index i = 0; i < roots.count(); ++i) {
    const RootPlace& r = roots.root(i);
    const bool in_list = r.oscillation >= 0    ? window.contains(oscillations[static_cast<std::size_t>(r.oscillation)].omega)
                         : r.lambda.real() > 0 ? r.lambda.imag() >= 0
                                               : r.lambda == 0.0 && window.contains(0);
    if (in_list) listed.push_back(i);
  }
  return listed;
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

void state_effects(const System& system, const MatrixSpectrum& spectrum, ModesResult& result, const Condensation* whole) {
  const std::vector<Mode> oscillations = spectrum.oscillations();
  const UnstableRoots unstable = spectrum.unstable();
  const RootVectors of_system(system, oscillations, unstable);
  const std::optional<RootVectors> of_whole =
      whole ? std::optional<RootVectors>(std::in_place, system, oscillations, unstable, whole) : std::nullopt;
  const RootVectors& roots = of_whole ? *of_whole : of_system;
  const ZeroModes zero(system, of_system, roots, spectrum.zero_shapes());
  const std::vector<Index> listed = listed_roots(roots, oscillations, result);
  for (Repair& r : result.repairs) {
    const Perturbation p(roots, r, false, listed);
    const Matrix dz = zero.dropped(r);
    Effect effect;
    if (lists_zero_modes(result)) effect.take(zero.effect_of(r, dz), 0, 0);
    for (const Index i : listed) {
      const RootPlace& root = roots.root(i);
      const Mode* m = root.oscillation < 0 ? nullptr : &oscillations[static_cast<std::size_t>(root.oscillation)];
      const Complex by_zero =
          m ? zero.on(r, dz, root.lambda, whole ? whole->expanded(root.lambda, m->shape) : m->shape, root.slope, p.power(root.lambda))
            : Complex(0);
      effect.take(p.moves(i, by_zero), root.lambda.imag(), m ? m->error_bound : 0);
    }
    store(r, effect);
  }
}

void state_effects(const FirstOrderSystem& system, const MatrixSpectrum& spectrum, ModesResult& result) {
  const std::vector<Mode> oscillations = spectrum.oscillations();
  const RootVectors roots(system, oscillations, spectrum.zero_shapes());
  const std::vector<Index> listed = listed_roots(roots, oscillations, result);
  for (Repair& r : result.repairs) {
    const Perturbation p(roots, r, true, listed);
    Effect effect;
    for (const Index i : listed) {
      const RootPlace& root = roots.root(i);
      const double error = root.oscillation < 0 ? 0 : oscillations[static_cast<std::size_t>(root.oscillation)].error_bound;
      effect.take(p.moves(i, 0), root.lambda.imag(), error);
    }
    store(r, effect);
  }
}

}  // namespace gyromode
