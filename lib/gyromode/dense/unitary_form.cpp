#include "gyromode/dense/unitary_form.h"

#include "gyromode/dense/mass_normal.h"
#include "gyromode/lapack/multiply.h"

#include <Eigen/Householder>
#include <Eigen/Jacobi>

namespace gyromode::dense {

namespace {

// N = −𝓗², 2n × 2n, skew-Hamiltonian: [A F; E Aᵀ] with E and F skew. With 𝓗 = [−½Γ 1; −(k + ¼ΓᵀΓ) −½Γ]: A = k − ½Γ², F
// = Γ, E = −½(kΓ + Γk) + ¼Γ³.
Matrix negative_square(const Matrix& gamma, const Matrix& k) {
  const Index n = k.rows();
  const Matrix gamma2 = lapack::multiply(gamma, gamma);
  const Matrix k_gamma = lapack::multiply(k, gamma);
  const Matrix gamma3 = lapack::multiply(gamma2, gamma);
  Matrix square(2 * n, 2 * n);
  square.topLeftCorner(n, n) = k - 0.5 * gamma2;
  square.bottomRightCorner(n, n) = k - 0.5 * gamma2;
  square.topRightCorner(n, n) = gamma;
  square.bottomLeftCorner(n, n) = -0.5 * (k_gamma - k_gamma.transpose()) + 0.125 * (gamma3 - gamma3.transpose());
  return square;
}

// One orthogonal symplectic step after the other, applied to N from both sides and to U from the right.
class Reduction {
 public:
  explicit Reduction(Matrix square)
      : n_(square.rows() / 2), square_(std::move(square)), u_(Matrix::Identity(2 * n_, 2 * n_)), work_(2 * n_) {}

  void run() {
    for (Index j = 0; j + 1 < n_; ++j) {
      reflect(square_.col(j).segment(n_ + j + 1, n_ - j - 1), j + 1);  // E below its diagonal: one entry left
      rotate(j);                                                       // and that one into A
      reflect(square_.col(j).segment(j + 1, n_ - j - 1), j + 1);       // A below its subdiagonal
    }
  }

  Matrix w() const { return Matrix(square_.topLeftCorner(n_, n_)).triangularView<Eigen::Upper>().toDenseMatrix() + subdiagonal(); }
  Matrix q1() const { return u_.topLeftCorner(n_, n_); }
  Matrix q2() const { return u_.topRightCorner(n_, n_); }

 private:
  Matrix subdiagonal() const {
    Matrix s = Matrix::Zero(n_, n_);
    for (Index j = 0; j + 1 < n_; ++j) s(j + 1, j) = square_(j + 1, j);
    return s;
  }

  // diag(P, P), P the reflection of coordinates from `first` on that takes the vector x there to a multiple of e₁.
  void reflect(const Eigen::Ref<const Vector>& x, Index first) {
    const Index count = n_ - first;
    if (count < 2) return;
    Vector essential(count - 1);
    double tau = 0, beta = 0;
    x.makeHouseholder(essential, tau, beta);
    if (tau == 0) return;
    for (const Index at : {first, n_ + first}) {
      square_.middleRows(at, count).applyHouseholderOnTheLeft(essential, tau, work_.data());
      square_.middleCols(at, count).applyHouseholderOnTheRight(essential, tau, work_.data());
      u_.middleCols(at, count).applyHouseholderOnTheRight(essential, tau, work_.data());
    }
  }

  // A rotation in the plane of z_i and p_i, i = j + 1, that makes E(i, j) zero.
  void rotate(Index j) {
    const Index i = j + 1;
    Eigen::JacobiRotation<double> g;
    g.makeGivens(square_(i, j), square_(n_ + i, j));
    square_.applyOnTheLeft(i, n_ + i, g.adjoint());
    square_.applyOnTheRight(i, n_ + i, g);
    u_.applyOnTheRight(i, n_ + i, g);
  }

  Index n_;
  Matrix square_, u_;
  Vector work_;
};

}  // namespace

UnitaryForm unitary_form(const System& system) {
  const MassNormal normal(system.mass());
  const Matrix gamma = normal.gyroscopic(system.gyroscopic());
  Reduction reduction(negative_square(gamma, normal.stiffness(system.stiffness())));
  reduction.run();
  UnitaryForm form{reduction.w(), reduction.q1(), reduction.q2(), {}, {}};
  // v = Q₂ᵀz + Q₁ᵀp, the lower half of Uᵀ(z, p), with z = N q and p = N q̇ + ½ΓN q.
  Matrix to_normal = Matrix::Identity(system.size(), system.size());
  normal.to_normal(to_normal);
  form.velocity = lapack::multiply_tn(form.q1, to_normal);
  form.displacement = lapack::multiply(form.q2.transpose() + 0.5 * lapack::multiply_tn(form.q1, gamma), to_normal);
  return form;
}

}  // namespace gyromode::dense
