// Measuring, energy signs, exhibits, verdicts and corrections on spectra made by hand: an impedance of uncoupled
// coordinates κ_i(k_i − ω²), whose roots, forms and counts are known in closed form. Nothing but the contract
// `Impedance` stands between them and the certificate.
#include "gyromode/certificate/energy_signs.h"
#include "gyromode/certificate/exhibits.h"
#include "gyromode/certificate/verdict.h"
#include "gyromode/refinement/correct.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gyromode {
namespace {

// Roots ±j√k_i where k_i > 0, of energy sign κ_i, and ±√−k_i where k_i < 0.
class Uncoupled : public Impedance {
 public:
  Uncoupled(Vector sign, Vector k) : m_(std::move(sign)), k_(m_.cwiseProduct(k)) {}

  Index size() const override { return m_.size(); }
  Index split() const override { return -1; }
  bool second_order() const override { return true; }
  RowProducts products(const Matrix& re, const Matrix& im) const override {
    const Matrix none = Matrix::Zero(re.rows(), re.cols());
    return {k_.asDiagonal() * re, k_.asDiagonal() * im, m_.asDiagonal() * re, m_.asDiagonal() * im, none, none};
  }
  CharacteristicProducts characteristic_products(const ComplexMatrix& x) const override {
    if (x.cols() == 0) return {};
    return {k_.cast<Complex>().asDiagonal() * x, ComplexMatrix::Zero(x.rows(), x.cols()), m_.cast<Complex>().asDiagonal() * x};
  }
  ComplexMatrix form(const ComplexMatrix& x, double omega) const override {
    return x.adjoint() * (2 * omega * m_).cast<Complex>().asDiagonal() * x;
  }
  Inertia inertia_at(double omega) const override {
    const Vector h = k_ - omega * omega * m_;
    const Vector terms = weight(omega);
    return {(h.array() < 0).count(), (h.array() > 0).count(), h.cwiseAbs().cwiseQuotient(terms).minCoeff()};
  }
  std::optional<DiscCount> roots_in_disc(Complex centre, double radius) const override {
    DiscCount found;
    for (Index i = 0; i < size(); ++i) {
      const Complex root = std::sqrt(Complex(-k_(i) / m_(i)));
      for (const Complex z : {root, -root}) found.roots += std::abs(z - centre) < radius ? 1 : 0;
    }
    return found;
  }
  Vector weight(double omega) const override { return k_.cwiseAbs() + omega * omega * m_.cwiseAbs(); }
  Vector rounding_weight(double omega) const override { return weight(omega); }
  double given_residual(const ComplexVector& r, const ComplexVector& x, double omega) const override {
    return r.norm() / (weight(omega).maxCoeff() * x.norm());
  }

 private:
  Vector m_, k_;
};

// The roots of `h` = Uncoupled(sign, k) as a solver would leave them, with n₋(K) such that the index balance closes.
Spectrum spectrum_of(const Vector& sign, const Vector& k) {
  const Index n = k.size();
  Spectrum s;
  std::vector<Index> modes;
  for (Index i = 0; i < n; ++i) {
    s.order.push_back(i);
    if (k(i) > 0)
      modes.push_back(i);
    else
      s.unstable.add(std::sqrt(-k(i)), ComplexVector::Unit(n, i), ComplexVector::Unit(n, i));
    s.stiffness_negative += k(i) < 0 ? 1 : sign(i) < 0 ? 2 : 0;
  }
  std::sort(modes.begin(), modes.end(), [&](Index i, Index j) { return k(i) < k(j); });
  const Index m = static_cast<Index>(modes.size());
  s.omega.resize(m);
  s.re = s.im = Matrix::Zero(n, m);
  for (Index c = 0; c < m; ++c) {
    s.omega(c) = std::sqrt(k(modes[static_cast<std::size_t>(c)]));
    s.re(modes[static_cast<std::size_t>(c)], c) = 1;
  }
  s.zero_shapes.resize(n, 0);
  s.reduced_negative = s.stiffness_negative;
  return s;
}

Verdict verdict_of(const Vector& sign, const Vector& k) {
  const Uncoupled h(sign, k);
  const Spectrum s = spectrum_of(sign, k);
  Assessment a = measure(h, s);
  return verdict_on(h, s, a);
}

TEST(Certificate, MeasuresRootsAsTheyStand) {
  const Vector sign = Vector::Ones(3), k{{1, 4, 9}};
  const Uncoupled h(sign, k);
  Spectrum s = spectrum_of(sign, k);
  s.omega(1) += 1e-6;
  const Spectrum before = s;
  const Assessment a = measure(h, s);
  EXPECT_EQ(s.omega, before.omega);  // nothing is changed
  EXPECT_NEAR(a.error_bound(1), 1e-6, 1e-11);
  EXPECT_LE(a.error_bound(0), 1e-15);
  EXPECT_NEAR(a.form(2), 6, 1e-14);
  EXPECT_NEAR(a.sensitivity(2), 3, 1e-14);  // a relative change of k and m moves ω by as much of it
}

TEST(Certificate, CorrectionMovesRootsAndSortsThem) {
  const Vector sign = Vector::Ones(3), k{{1, 4, 9}};
  const Uncoupled h(sign, k);
  Spectrum s = spectrum_of(sign, k);
  s.omega = Vector{{1 + 1e-5, 2 - 1e-6, 3}};
  s.re.col(0).swap(s.re.col(1));
  std::swap(s.omega(0), s.omega(1));  // not in order any more
  const Assessment a = correct(h, s);
  EXPECT_LE((s.omega - Vector{{1, 2, 3}}).norm(), 1e-15);
  EXPECT_EQ(s.re(0, 0), 1);
  EXPECT_EQ(s.re(1, 1), 1);
  EXPECT_LE(a.error_bound.maxCoeff(), 1e-14);
}

TEST(Certificate, RootsThatAreFarOffAreLeft) {
  const Vector sign = Vector::Ones(2), k{{1, 4}};
  const Uncoupled h(sign, k);
  Spectrum s = spectrum_of(sign, k);
  s.omega(0) = 1.2;  // a jump, no correction
  const Assessment a = correct(h, s);
  EXPECT_EQ(s.omega(0), 1.2);
  EXPECT_GT(a.error_bound(0), 0.1);
}

TEST(Certificate, SignsOfSimpleRoots) {
  const Vector sign{{1, -1, 1}}, k{{1, 4, 9}};
  const Verdict v = verdict_of(sign, k);
  EXPECT_EQ(v.energy_sign, (std::vector<int>{1, -1, 1}));
  EXPECT_NEAR(v.gap, 1.0 / 3, 1e-15);  // from 2 to 3
  EXPECT_TRUE(v.balance.closed);
  EXPECT_EQ(v.balance.negative_energy, 1);
  EXPECT_EQ(v.stability, Stability::gyroscopically_stabilised);
}

// At any scale a pair of opposite sign that rounding can bring together is undecided and marginal; one apart by more is
// not.
TEST(Certificate, PairsOfOppositeSign) {
  for (const double scale : {0x1p-60, 1.0, 0x1p60}) {
    for (const auto& [apart, undecided] : {std::pair(0.0, true), std::pair(1e-16, true), std::pair(1e-3, false)}) {
      const Verdict v = verdict_of(Vector{{1, -1}}, scale * Vector{{1, 1 + apart}});
      EXPECT_EQ(v.energy_sign, undecided ? (std::vector<int>{0, 0}) : (std::vector<int>{1, -1})) << apart << " " << scale;
      EXPECT_EQ(v.stability, undecided ? Stability::marginal : Stability::gyroscopically_stabilised);
      EXPECT_EQ(v.balance.negative_energy, 1);
      EXPECT_TRUE(v.balance.closed);
    }
  }
}

TEST(Certificate, AnUnstableRootIsShownOrTheBalanceIsOpen) {
  const Vector sign = Vector::Ones(2), k{{-4, 9}};
  const Uncoupled h(sign, k);
  Spectrum s = spectrum_of(sign, k);
  Assessment a = measure(h, s);
  const Verdict shown = verdict_on(h, s, a);
  EXPECT_EQ(shown.stability, Stability::unstable);
  EXPECT_TRUE(shown.balance.closed && shown.unstable_shown[0]);
  s.unstable.lambda[0] = 2.7;  // where none is
  a = measure(h, s);
  const Verdict wrong = verdict_on(h, s, a);
  EXPECT_FALSE(wrong.balance.closed);
  EXPECT_FALSE(wrong.unstable_shown[0]);
  EXPECT_EQ(wrong.stability, Stability::unknown);
  EXPECT_NE(wrong.reason.find("could not be shown to exist"), std::string::npos) << wrong.reason;
}

TEST(Certificate, ALostRootOpensTheBalance) {
  const Vector sign = Vector::Ones(3), k{{1, 4, 9}};
  const Uncoupled h(sign, k);
  Spectrum s = spectrum_of(sign, k);
  s.omega.conservativeResize(2);
  s.re.conservativeResize(3, 2);
  s.im.conservativeResize(3, 2);
  Assessment a = measure(h, s);
  const Verdict v = verdict_on(h, s, a);
  EXPECT_FALSE(v.balance.closed);
  EXPECT_EQ(v.reason, "2 of 3 roots were found");
}

TEST(Certificate, AnIndexThatTheRootsDoNotAccountFor) {
  const Vector sign = Vector::Ones(2), k{{1, 4}};
  const Uncoupled h(sign, k);
  Spectrum s = spectrum_of(sign, k);
  s.stiffness_negative = s.reduced_negative = 2;
  Assessment a = measure(h, s);
  const Verdict v = verdict_on(h, s, a);
  EXPECT_FALSE(v.balance.closed);
  EXPECT_NE(v.reason.find("K has 2 negative eigenvalues where the roots found account for 0"), std::string::npos) << v.reason;
}

// Two roots in one disc are counted together, and the disc becomes their bound.
TEST(Certificate, RootsCountedTogetherInADisc) {
  const Vector sign = Vector::Ones(3), k{{-4, -4 * (1 + 1e-9), 25}};
  const Uncoupled h(sign, k);
  Spectrum s = spectrum_of(sign, k);
  s.unstable.right.col(1) = s.unstable.right.col(0);  // no shape of its own: its span tells nothing
  s.unstable.left.col(1) = s.unstable.left.col(0);
  Assessment a = measure(h, s);
  const Exhibits e = exhibited(h, s, a);
  EXPECT_TRUE(e.all) << e.reason;
  EXPECT_GT(a.unstable.error_bound(0), 1e-9);
  EXPECT_LT(a.unstable.error_bound(0), 1);
}

}  // namespace
}  // namespace gyromode
