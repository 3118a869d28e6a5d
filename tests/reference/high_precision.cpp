#include "high_precision.h"

#include "gyromode/base/error.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace gyromode::reference {
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;
}  // namespace gyromode::reference

// Boost 1.74 has a NumTraits of its own, but without the infinity() and quiet_NaN() that Eigen 3.4 asks for.
template <>
struct Eigen::NumTraits<gyromode::reference::Real> : Eigen::GenericNumTraits<gyromode::reference::Real> {
  enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = 4, AddCost = 16, MulCost = 32 };
};

namespace gyromode::reference {
namespace {

using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Eigen::Index;

const Real zero_threshold("1e-50");
const Real null_threshold("1e-30");
const Real cluster_threshold("1e-18");

// ---- promises

void require(bool promise, const char* message) {
  if (!promise) throw InvalidArgument(std::string("gyromode::reference: ") + message);
}

void check(const Eigen::MatrixXd& M, const Eigen::MatrixXd& G, const Eigen::MatrixXd& K) {
  const Index n = M.rows();
  require(M.cols() == n && G.rows() == n && G.cols() == n && K.rows() == n && K.cols() == n, "M, G and K must be square and of one size");
  require(M.allFinite() && G.allFinite() && K.allFinite(), "M, G and K must be finite");
  require(M == M.transpose(), "M must satisfy M = Mᵀ exactly");
  require(G == -G.transpose(), "G must satisfy G = −Gᵀ exactly");
  require(K == K.transpose(), "K must satisfy K = Kᵀ exactly");
}

void ensure(bool holds, const char* message) {
  if (!holds) throw std::logic_error(std::string("gyromode::reference, inner contradiction: ") + message);
}

Real largest_entry(const Matrix& A) { return A.size() == 0 ? Real(0) : A.cwiseAbs().maxCoeff(); }

Vector symmetric_eigenvalues(const Matrix& S) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(S, Eigen::EigenvaluesOnly);
  ensure(solver.info() == Eigen::Success, "the symmetric QR iteration did not converge");
  return solver.eigenvalues();
}

// ---- Hermitian matrices as real symmetric ones of twice the size

/// A + jB Hermitian (A = Aᵀ, B = −Bᵀ)  ↦  [A −B; B A], in which every eigenvalue appears twice.
Matrix embedding(const Matrix& A, const Matrix& B) {
  const Index n = A.rows();
  Matrix E(2 * n, 2 * n);
  E << A, -B, B, A;
  return E;
}

/// Number of eigenvalues of S = Sᵀ below a bound ≠ 0: tridiagonalise, T = QᵀSQ, and count the negative pivots of the
/// LDLᵀ of T − bound (Sturm). A pivot that is exactly zero is moved by far less than the bound.
int eigenvalues_below(const Real& bound, const Matrix& S) {
  const Real tiny = Real("1e-40") * abs(bound);
  const Eigen::Tridiagonalization<Matrix> T(S);
  const Vector a = T.diagonal(), b = T.subDiagonal();
  int negative = 0;
  Real pivot = 1;
  for (Index i = 0; i < a.size(); ++i) {
    pivot = a[i] - bound - (i == 0 ? Real(0) : Real(b[i - 1] * b[i - 1] / pivot));
    if (pivot == 0) pivot = tiny;
    if (pivot < 0) ++negative;
  }
  return negative;
}

/// H(w) = K − w²M + jwG, embedded, and the size of its terms: at a root H itself may be nothing but rounding.
struct Impedance {
  Matrix H;
  Real scale;

  Impedance(const Matrix& M, const Matrix& G, const Matrix& K, const Real& w)
      : H(embedding(K - w * w * M, w * G)), scale(largest_entry(K) + w * w * largest_entry(M) + abs(w) * largest_entry(G)) {}

  /// n₋(H); an eigenvalue within 1e-50 of zero is not negative.
  int negative_eigenvalues() const {
    if (scale == 0) return 0;
    const int twice = eigenvalues_below(-zero_threshold * scale, H);
    ensure(twice % 2 == 0, "odd inertia of the real embedding of a Hermitian matrix");
    return twice / 2;
  }
};

// ---- the system in mass-normalised coordinates and its own unit of time

/// q' = Lᵀq, M = LLᵀ, and time in units of 1/rate:   k = L⁻¹KL⁻ᵀ/rate²,  g = L⁻¹GL⁻ᵀ/rate,  max(|k|, |g|) = 1,
/// h(w) = k − w² + jwg,  λ = rate · (roots of k, g).
struct Normalised {
  Matrix k, g;
  Real rate = 1;

  Index size() const { return k.rows(); }
  Matrix one() const { return Matrix::Identity(size(), size()); }
  Impedance impedance(const Real& w) const { return Impedance(one(), g, k, w); }
  int count(const Real& w) const { return impedance(w).negative_eigenvalues(); }
};

/// L⁻¹ A L⁻ᵀ
Matrix congruent(const Matrix& L, const Matrix& A) {
  const auto lower = L.triangularView<Eigen::Lower>();
  const Matrix half = lower.solve(A);
  return lower.solve(half.transpose()).transpose();
}

Normalised normalise(const Eigen::MatrixXd& M, const Eigen::MatrixXd& G, const Eigen::MatrixXd& K) {
  const Eigen::LLT<Matrix> cholesky(M.cast<Real>());
  require(cholesky.info() == Eigen::Success, "M must be positive definite");
  const Matrix L = cholesky.matrixL();
  const Matrix k = congruent(L, K.cast<Real>()), g = congruent(L, G.cast<Real>());
  Normalised s;
  s.rate = std::max<Real>(sqrt(largest_entry(k)), largest_entry(g));
  if (s.rate == 0) s.rate = 1;
  s.k = (k + k.transpose()) / (2 * s.rate * s.rate);
  s.g = (g - g.transpose()) / (2 * s.rate);
  return s;
}

/// d/dt (q, q̇) = A (q, q̇),  A = [0 1; −k −g]
Matrix companion(const Normalised& s) {
  const Index n = s.size();
  Matrix A(2 * n, 2 * n);
  A << Matrix::Zero(n, n), Matrix::Identity(n, n), -s.k, -s.g;
  return A;
}

// ---- roots

/// The non-zero part of A. With Q = [Q₁ N], N an orthonormal basis of null A, QᵀAQ = [C 0; * 0]: the spectrum of A is
/// that of C = Q₁ᵀAQ₁ and dim N zeros. Repeat until C is nonsingular; every zero is found, whatever its Jordan blocks.
/// Pivots are compared with the entries of the first A, since a nilpotent C is nothing but rounding.
Matrix without_zero_roots(Matrix A) {
  const Real zero = zero_threshold * largest_entry(A);
  while (A.rows() > 0) {
    const Eigen::ColPivHouseholderQR<Matrix> qr(A.transpose());  // range Aᵀ = (null A)^⊥
    const Vector pivots = qr.matrixQR().diagonal().cwiseAbs();
    const Index rank = (pivots.array() > zero).count();
    if (rank == A.rows()) break;
    const Matrix Q1 = Matrix(qr.householderQ()).leftCols(rank);
    A = (Q1.transpose() * A * Q1).eval();
  }
  return A;
}

/// λ² = re + j im. The roots come as ±λ, so every λ² appears twice.
struct Square {
  Real re, im;
};

Real modulus(const Square& z) { return hypot(z.re, z.im); }

/// λ² for λ = p ± √d, the eigenvalues of [a b; c e]:  p = (a + e)/2,  d = (a − e)²/4 + bc.
void append_squares(const Real& a, const Real& b, const Real& c, const Real& e, std::vector<Square>& squares) {
  const Real p = (a + e) / 2, half = (a - e) / 2, d = half * half + b * c;
  const Real root = sqrt(abs(d));
  if (d >= 0) {
    squares.push_back({(p + root) * (p + root), 0});
    squares.push_back({(p - root) * (p - root), 0});
  } else {
    squares.push_back({p * p - root * root, 2 * p * root});
    squares.push_back({p * p - root * root, -2 * p * root});
  }
}

/// QR on A + c: Eigen deflates when a subdiagonal entry is small beside its diagonal neighbours, and on the imaginary
/// axis those vanish. At a defective root each step gains a few bits, instead of doubling the digits: hence the number
/// of iterations.
Matrix real_schur_form(const Matrix& A) {
  const Matrix shift = Real(std::numbers::pi) * largest_entry(A) * Matrix::Identity(A.rows(), A.rows());
  Eigen::RealSchur<Matrix> schur(A.rows());
  schur.setMaxIterations(1000 * A.rows());
  schur.compute(A + shift, false);
  ensure(schur.info() == Eigen::Success, "the QR iteration did not converge");
  return schur.matrixT() - shift;
}

std::vector<Square> squared_roots(const Matrix& A) {
  std::vector<Square> squares;
  if (A.rows() == 0) return squares;
  const Matrix T = real_schur_form(A);
  for (Index i = 0; i < T.rows(); ++i) {
    if (i + 1 < T.rows() && T(i + 1, i) != 0) {
      append_squares(T(i, i), T(i, i + 1), T(i + 1, i), T(i + 1, i + 1), squares);
      ++i;
    } else {
      squares.push_back({T(i, i) * T(i, i), 0});
    }
  }
  return squares;
}

/// Roots λ² that are one root. The mean is accurate to working precision even where the members have split, being the
/// trace on an invariant subspace.
struct Cluster {
  Square mean;
  int multiplicity;  // of λ² as a root of det(λ²M + λG + K), a polynomial in λ²
};

bool coincide(const Square& a, const Square& b) {
  return modulus({a.re - b.re, a.im - b.im}) <= cluster_threshold * std::max(modulus(a), modulus(b));
}

/// Moves everything linked to `seed` by a chain of coincidences out of `rest`.
std::vector<Square> take_cluster(const Square& seed, std::vector<Square>& rest) {
  std::vector<Square> members{seed};
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Square member = members[i];
    const auto linked = std::stable_partition(rest.begin(), rest.end(), [&](const Square& z) { return !coincide(z, member); });
    members.insert(members.end(), linked, rest.end());
    rest.erase(linked, rest.end());
  }
  return members;
}

std::vector<Cluster> clusters(std::vector<Square> squares) {
  std::vector<Cluster> found;
  while (!squares.empty()) {
    const Square seed = squares.back();
    squares.pop_back();
    const std::vector<Square> members = take_cluster(seed, squares);
    Square mean{0, 0};
    for (const Square& z : members) mean = {mean.re + z.re, mean.im + z.im};
    const int size = static_cast<int>(members.size());
    ensure(size % 2 == 0, "roots do not pair as ±λ");
    found.push_back({{mean.re / size, mean.im / size}, size / 2});
  }
  return found;
}

// ---- energy signs

struct Signature {
  int positive = 0, negative = 0;
};

/// Orthonormal basis of the embedded null space of h(w); its dimension is 2 at a simple root, by definition, and
/// otherwise decided.
Matrix null_space(const Impedance& h, int multiplicity) {
  const Eigen::ColPivHouseholderQR<Matrix> qr(h.H);  // H = Hᵀ: null H = (range H)^⊥
  const Vector pivots = qr.matrixQR().diagonal().cwiseAbs();
  const Index decided = (pivots.array() <= null_threshold * h.scale).count();
  const Index dimension = multiplicity == 1 ? 2 : decided;
  ensure(dimension >= 2 && dimension % 2 == 0 && dimension <= 2 * multiplicity, "no null vectors of H at a root");
  return Matrix(qr.householderQ()).rightCols(dimension);
}

/// Signature of Xᴴ(2w − jg)X = −d(XᴴhX)/dw on null h(w). Jordan blocks of size > 1 have isotropic eigenvectors and add
/// nothing, so positive + negative = multiplicity iff the root is semisimple.
Signature energy_signature(const Normalised& s, const Real& w, int multiplicity) {
  const Matrix N = null_space(s.impedance(w), multiplicity);
  const Matrix form = N.transpose() * embedding(2 * w * s.one(), -s.g) * N;
  const Vector energies = symmetric_eigenvalues((form + form.transpose()) / 2);
  const Real zero = multiplicity == 1 ? Real(0) : Real(null_threshold * (2 * w + largest_entry(s.g)));
  const Index positive = (energies.array() > zero).count(), negative = (energies.array() < -zero).count();
  ensure(positive % 2 == 0 && negative % 2 == 0, "odd signature of the real embedding of a Hermitian form");
  return {static_cast<int>(positive / 2), static_cast<int>(negative / 2)};
}

struct AxisRoot {
  Real w;
  int multiplicity;
  Signature energy;

  int defect() const { return multiplicity - energy.positive - energy.negative; }
  bool coinciding_opposites() const { return defect() > 0 || (energy.positive > 0 && energy.negative > 0); }
};

/// (T9) on each side of each root: n₋(h) rises by (positive − negative). A Jordan block changes it by 0 (even size) or
/// ±1 (odd size, hence ≥ 3).
void verify_by_counting(const Normalised& s, const std::vector<AxisRoot>& roots) {
  if (roots.empty()) return;
  int below = s.count(roots.front().w / 2);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const Real beyond = i + 1 < roots.size() ? Real((roots[i].w + roots[i + 1].w) / 2) : Real(2 * roots[i].w);
    const int above = s.count(beyond);
    const Signature& e = roots[i].energy;
    const int unexplained = above - below - (e.positive - e.negative);
    ensure(3 * std::abs(unexplained) <= roots[i].defect(), "the inertia of H does not jump by the energy signs");
    below = above;
  }
}

// ---- the sorted spectrum, in units of rate

struct Roots {
  int zeros = 0;
  std::vector<AxisRoot> axis;                  // λ = ±jw
  std::vector<Real> divergence;                // λ = ±σ
  std::vector<std::pair<Real, Real>> flutter;  // λ = ±σ ± jω
  Real largest = 0;                            // max|λ|
};

/// √(re + j im) = σ + jω, im > 0, without cancellation: the larger part from the modulus, the smaller from 2σω = im.
std::pair<Real, Real> square_root(const Square& z) {
  const Real major = sqrt((modulus(z) + abs(z.re)) / 2), minor = z.im / (2 * major);
  return z.re >= 0 ? std::pair(major, minor) : std::pair(minor, major);
}

/// By symmetry: λ² < 0 is a pair on the axis, λ² > 0 a real pair, λ² complex (with its conjugate) a quadruple. A
/// cluster is real iff it holds its conjugate.
void classify(const Normalised& s, const Cluster& c, Roots& roots) {
  roots.largest = std::max<Real>(roots.largest, sqrt(modulus(c.mean)));
  const bool real = coincide(c.mean, {c.mean.re, -c.mean.im});
  if (real && c.mean.re < 0) {
    const Real w = sqrt(-c.mean.re);
    roots.axis.push_back({w, c.multiplicity, energy_signature(s, w, c.multiplicity)});
  } else if (real) {
    roots.divergence.insert(roots.divergence.end(), static_cast<std::size_t>(c.multiplicity), sqrt(c.mean.re));
  } else if (c.mean.im > 0) {
    roots.flutter.insert(roots.flutter.end(), static_cast<std::size_t>(c.multiplicity), square_root(c.mean));
  }
}

Roots all_roots(const Normalised& s) {
  Roots roots;
  const Matrix A = without_zero_roots(companion(s));
  roots.zeros = static_cast<int>(2 * s.size() - A.rows());
  for (const Cluster& c : clusters(squared_roots(A))) classify(s, c, roots);
  std::sort(roots.axis.begin(), roots.axis.end(), [](const AxisRoot& a, const AxisRoot& b) { return a.w < b.w; });
  std::sort(roots.divergence.begin(), roots.divergence.end());
  std::sort(roots.flutter.begin(), roots.flutter.end());
  verify_by_counting(s, roots.axis);
  return roots;
}

// ---- verdict and distance

Spectrum::Verdict verdict(const Spectrum& result, const Roots& roots) {
  using enum Spectrum::Verdict;
  if (result.negative_stiffness == 0) return stable;
  if (!roots.divergence.empty() || !roots.flutter.empty()) return unstable;
  const bool opposites = std::any_of(roots.axis.begin(), roots.axis.end(), [](const AxisRoot& r) { return r.coinciding_opposites(); });
  return opposites || roots.zeros > 0 ? marginal : gyroscopically_stabilised;
}

/// (a) of Spectrum::distance, not yet divided by max|λ|; max|λ| itself if all signs agree.
Real opposite_gap(const Roots& roots) {
  Real gap = roots.largest;
  for (std::size_t i = 0; i < roots.axis.size(); ++i) {
    const AxisRoot& r = roots.axis[i];
    if (r.coinciding_opposites()) return 0;
    if (i == 0) continue;
    const AxisRoot& previous = roots.axis[i - 1];
    if ((r.energy.positive > 0) != (previous.energy.positive > 0)) gap = std::min<Real>(gap, r.w - previous.w);
  }
  return gap;
}

/// (a) and (b)
Real root_distance(const Roots& roots) {
  if (roots.largest == 0) return 1;
  Real nearest = opposite_gap(roots);
  for (const Real& sigma : roots.divergence) nearest = std::min(nearest, sigma);
  for (const auto& [sigma, omega] : roots.flutter) nearest = std::min(nearest, sigma);
  return nearest / roots.largest;
}

/// Inertia of K, and (c).
Real stiffness_inertia(const Eigen::MatrixXd& K, Spectrum& result) {
  if (K.rows() == 0) return 1;
  const Vector kappa = symmetric_eigenvalues(K.cast<Real>());
  const Real largest = largest_entry(kappa), zero = zero_threshold * largest;
  Real smallest = largest;
  for (const Real& value : kappa) {
    if (abs(value) <= zero) {
      ++result.zero_stiffness;
      continue;
    }
    if (value < 0) ++result.negative_stiffness;
    smallest = std::min<Real>(smallest, abs(value));
  }
  return largest == 0 ? Real(1) : Real(smallest / largest);
}

double rounded(const Real& x) { return x.convert_to<double>(); }

void write_axis_root(const AxisRoot& r, const Real& rate, Spectrum& result) {
  const double omega = rounded(rate * r.w);
  for (int i = 0; i < r.multiplicity; ++i) {
    const int positive = r.energy.positive, negative = r.energy.negative;
    result.omega.push_back(omega);
    result.energy_sign.push_back(i < positive ? 1 : i < positive + negative ? -1 : 0);
  }
}

}  // namespace

Spectrum spectrum(const Eigen::MatrixXd& M, const Eigen::MatrixXd& G, const Eigen::MatrixXd& K) {
  check(M, G, K);
  Spectrum result;
  if (M.rows() == 0) return result;
  const Normalised s = normalise(M, G, K);
  const Roots roots = all_roots(s);
  result.zero_roots = roots.zeros;
  for (const AxisRoot& r : roots.axis) write_axis_root(r, s.rate, result);
  for (const Real& sigma : roots.divergence) result.divergence.push_back(rounded(s.rate * sigma));
  for (const auto& [sigma, omega] : roots.flutter) result.flutter.emplace_back(rounded(s.rate * sigma), rounded(s.rate * omega));

  const Real stiffness_distance = stiffness_inertia(K, result);
  result.verdict = verdict(result, roots);
  const bool marginal = result.verdict == Spectrum::Verdict::marginal;
  result.distance = marginal ? 0.0 : rounded(std::min(stiffness_distance, root_distance(roots)));
  return result;
}

int negative_eigenvalues_of_impedance(const Eigen::MatrixXd& M, const Eigen::MatrixXd& G, const Eigen::MatrixXd& K, double omega) {
  check(M, G, K);
  require(std::isfinite(omega), "ω must be finite");
  if (M.rows() == 0) return 0;
  return Impedance(M.cast<Real>(), G.cast<Real>(), K.cast<Real>(), omega).negative_eigenvalues();
}

}  // namespace gyromode::reference
