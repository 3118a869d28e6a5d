#pragma once

#include "gyromode/base/types.h"

namespace gyromode::sparse {

/// States of a motion, length × m, and E times them, E an inner product.
struct States {
  Matrix x, ex;
};

/// A real operator whose outermost eigenvalues θ are the roots near a shift, self-adjoint or skew-adjoint in a definite
/// inner product ⟨u, v⟩ = uᵀEv (theory sparse §2–4).
class Inverse {
 public:
  virtual ~Inverse() = default;

  virtual Index length() const = 0;                      ///< of a state
  virtual Index dimension() const { return length(); }   ///< of the space of states
  virtual bool skew() const { return false; }            ///< then θ is imaginary, and |θ| stands for it
  virtual States start(const Matrix& shapes) const = 0;  ///< smooth states from shapes, n × m, of any kind
  virtual States apply(const States& u) const = 0;       ///< of u, and E times that, without a product with K where it can be
  virtual Matrix inner(const Matrix& x) const = 0;       ///< Ex, by products
  /// Puts the part of Ex that M makes right, as apply() takes it from there; that of K stays as it was carried along.
  virtual void settle(States& u) const = 0;
  /// Whether E by products has more rounding, ε‖K‖‖x‖² of the ω²‖x‖² that the lowest roots looked for have, than what
  /// apply() gives and is carried along.
  virtual bool rough_products() const { return true; }
  virtual double square(double theta) const = 0;     ///< ω² (−λ²) of an eigenvalue
  virtual Index leading_group() const { return 0; }  ///< of a partition: a state has its displacements and the others' velocities
  /// Whether a state, or two where they come in pairs, is one motion; else shapes that span those of all are known.
  virtual bool motions() const { return true; }
  /// Real shapes that span those of the motions, n × any number; of states that are motions, in the order of
  /// coordinates.
  virtual Matrix shapes(const Matrix& states) const = 0;
  virtual Matrix states(const Matrix& in_order) const { return in_order; }  ///< the other way about
};

}  // namespace gyromode::sparse
