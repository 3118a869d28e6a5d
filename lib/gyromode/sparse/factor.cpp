#include "gyromode/sparse/factor.h"

#include "gyromode/base/error.h"

#include <dmumps_c.h>

#include <fmt/format.h>

#include <cassert>

namespace gyromode::sparse {

// The arrays that MUMPS has pointers to.
struct SymmetricFactor::Instance {
  DMUMPS_STRUC_C mumps{};
  std::vector<int> rows, columns, order;
  std::vector<double> values;

  void run(int job) {
    mumps.job = job;
    dmumps_c(&mumps);
  }
  int& control(int which) { return mumps.icntl[which - 1]; }
  int status() const { return mumps.infog[0]; }
};

namespace {

constexpr int job_begin = -1, job_end = -2, job_analyse = 1, job_factorise = 2, job_solve = 3;
constexpr int too_little_workspace[] = {-8, -9, -11, -14, -15, -17, -20};

bool wants_more_workspace(int status) {
  for (const int s : too_little_workspace) {
    if (s == status) return true;
  }
  return false;
}

}  // namespace

SymmetricFactor::SymmetricFactor(const SparseMatrix& pattern, const std::vector<int>& order, Keep keep, Kind kind)
    : of_(std::make_unique<Instance>()), keep_(keep), size_(pattern.cols()), non_zeros_(pattern.nonZeros()) {
  Instance& m = *of_;
  m.mumps.sym = kind == Kind::definite ? 1 : 2;
  m.mumps.par = 1;
  m.mumps.comm_fortran = -987654;  // MPI_COMM_WORLD
  m.run(job_begin);
  for (const int stream : {1, 2, 3, 4}) m.control(stream) = 0;  // silent
  m.control(7) = 1;                                             // the order given
  m.control(31) = keep == Keep::counts ? 1 : 0;
  m.rows.reserve(static_cast<std::size_t>(non_zeros_));
  m.columns.reserve(static_cast<std::size_t>(non_zeros_));
  for (Index j = 0; j < pattern.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(pattern, j); it; ++it) {
      m.rows.push_back(static_cast<int>(it.row()) + 1);
      m.columns.push_back(static_cast<int>(j) + 1);
    }
  }
  m.order = order;
  for (int& position : m.order) ++position;
  m.mumps.n = static_cast<int>(size_);
  m.mumps.nnz = static_cast<MUMPS_INT8>(non_zeros_);
  m.mumps.irn = m.rows.data();
  m.mumps.jcn = m.columns.data();
  m.mumps.perm_in = m.order.data();
  m.run(job_analyse);
  if (m.status() < 0)
    throw TooLarge(
        fmt::format("the matrix of order {} could not be analysed for factorisation (MUMPS {}, {})", size_, m.status(), m.mumps.infog[1]));
}

SymmetricFactor::~SymmetricFactor() { of_->run(job_end); }

double SymmetricFactor::megabytes() const { return of_->mumps.infog[20] > 0 ? of_->mumps.infog[20] : of_->mumps.infog[16]; }

double SymmetricFactor::entries() const {
  const int n = of_->mumps.infog[2];
  return n >= 0 ? n : -1e6 * n;  // in millions where it is large
}

Index SymmetricFactor::factor(const SparseMatrix& lower) {
  assert(lower.nonZeros() == non_zeros_ && lower.cols() == size_);
  Instance& m = *of_;
  m.values.assign(lower.valuePtr(), lower.valuePtr() + lower.nonZeros());
  m.mumps.a = m.values.data();
  // % of workspace more than estimated: pivoting needs it.
  constexpr int most_workspace = 1000, without_pivoting = 3, with_pivoting = 30;
  for (int percent = m.mumps.sym == 1 ? without_pivoting : with_pivoting;; percent *= 3) {
    m.control(14) = percent;
    m.run(job_factorise);
    if (!wants_more_workspace(m.status()) || percent > most_workspace) break;
  }
  if (m.status() == -13 || m.status() < -1000 || wants_more_workspace(m.status()))
    throw TooLarge(fmt::format(
        "factorising a matrix of order {} with {:.3g} entries in its factor takes some {} MB, which are not there (MUMPS {}, {})", size_,
        entries(), m.mumps.infog[16], m.status(), m.mumps.infog[1]));
  if (m.status() < 0 && m.status() != -10)  // −10: numerically singular, which counts decide
    throw NotConverged(fmt::format("a matrix of order {} could not be factorised (MUMPS {}, {})", size_, m.status(), m.mumps.infog[1]));
  singular_ = m.status() == -10;
  return m.mumps.infog[11];
}

Matrix SymmetricFactor::solve(Matrix b) {
  assert(keep_ == Keep::factors && b.rows() == size_);
  if (b.cols() == 0) return b;
  Instance& m = *of_;
  m.mumps.rhs = b.data();
  m.mumps.nrhs = static_cast<int>(b.cols());
  m.mumps.lrhs = static_cast<int>(size_);
  constexpr int at_once = 32;
  m.control(27) = std::min<int>(static_cast<int>(b.cols()), at_once);
  m.run(job_solve);
  if (m.status() < 0) throw NotConverged(fmt::format("a system of order {} could not be solved (MUMPS {})", size_, m.status()));
  return b;
}

}  // namespace gyromode::sparse
