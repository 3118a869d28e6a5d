#include "reference/matrix_exponential.h"

#include <arb_mat.h>

#include <stdexcept>

namespace gyromode::reference {

namespace {

constexpr slong bits = 600;  // 50 digits are left after cancellation in exponentials of norm 10⁴

class Balls {
 public:
  Balls(Index rows, Index cols) { arb_mat_init(m_, rows, cols); }
  ~Balls() { arb_mat_clear(m_); }
  Balls(const Balls&) = delete;
  Balls& operator=(const Balls&) = delete;

  arb_mat_struct* get() { return m_; }
  arb_ptr at(Index i, Index k) { return arb_mat_entry(m_, i, k); }
  void set(Index i, Index k, double x) { arb_set_d(at(i, k), x); }

 private:
  arb_mat_t m_;
};

}  // namespace

State exact_state(const System& s, const State& initial, double t) { return exact_state(s, initial, Vector::Zero(s.size()), 0, t); }

State exact_state(const System& s, const State& initial, const Vector& force, double nu, double t) {
  const Index n = s.size(), order = 2 * n + 2;
  Balls mass(n, n), right(n, 2 * n + 1), solved(n, 2 * n + 1), a(order, order), e(order, order), x(order, 1), y(order, 1);
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < n; ++k) {
      mass.set(i, k, s.mass()(i, k));
      right.set(i, k, -s.stiffness()(i, k));
      right.set(i, n + k, -s.gyroscopic()(i, k));
    }
    right.set(i, 2 * n, force(i));
  }
  if (!arb_mat_solve(solved.get(), mass.get(), right.get(), bits)) throw std::runtime_error("M is singular in 600 bits");
  for (Index i = 0; i < n; ++i) {
    a.set(i, n + i, 1);
    for (Index k = 0; k <= 2 * n; ++k) arb_set(a.at(n + i, k), solved.at(i, k));
    x.set(i, 0, initial.q(i));
    x.set(n + i, 0, initial.qdot(i));
  }
  a.set(2 * n, 2 * n + 1, -nu);
  a.set(2 * n + 1, 2 * n, nu);
  x.set(2 * n, 0, 1);
  arb_t time;
  arb_init(time);
  arb_set_d(time, t);
  arb_mat_scalar_mul_arb(a.get(), a.get(), time, bits);
  arb_clear(time);
  arb_mat_exp(e.get(), a.get(), bits);
  arb_mat_mul(y.get(), e.get(), x.get(), bits);
  State w{Vector(n), Vector(n)};
  for (Index i = 0; i < n; ++i) {
    for (Index k : {i, n + i}) {
      if (arb_rel_accuracy_bits(y.at(k, 0)) < 60 && !arb_contains_zero(y.at(k, 0)))
        throw std::runtime_error("ball arithmetic lost its digits");
    }
    w.q(i) = arf_get_d(arb_midref(y.at(i, 0)), ARF_RND_NEAR);
    w.qdot(i) = arf_get_d(arb_midref(y.at(n + i, 0)), ARF_RND_NEAR);
  }
  return w;
}

}  // namespace gyromode::reference
