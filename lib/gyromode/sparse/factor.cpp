#include "gyromode/sparse/factor.h"

#include "gyromode/base/error.h"
#include "gyromode/sparse/factor_memory.h"

#include <dmumps_c.h>

#include <fmt/format.h>

#include <cassert>
#include <cstring>
#include <system_error>

namespace gyromode::sparse {

struct SymmetricFactor::Instance {
  DMUMPS_STRUC_C mumps{};

  void run(int job) {
    mumps.job = job;
    dmumps_c(&mumps);
  }
  int& control(int which) { return mumps.icntl[which - 1]; }
  int status() const { return mumps.infog[0]; }
};

namespace {

constexpr int job_begin = -1, job_end = -2, job_analyse = 1, job_factorise = 2, job_solve = 3;
constexpr int too_little_workspace[] = {-8, -9, -11, -14, -15, -17, -20}, files_failed = -90;
constexpr double megabyte = 1e6, bytes_an_entry = 8, unlimited = std::numeric_limits<double>::infinity();
// % of workspace more than estimated: pivoting needs it.
constexpr int without_pivoting = 3, with_pivoting = 30;

bool wants_more_workspace(int status) {
  for (const int s : too_little_workspace) {
    if (s == status) return true;
  }
  return false;
}

// The entries of a matrix as MUMPS has pointers to them: while it analyses or factors, not while it solves.
class Entries {
 public:
  Entries(const SparseMatrix& lower, DMUMPS_STRUC_C& mumps) : values_(lower.valuePtr(), lower.valuePtr() + lower.nonZeros()) {
    rows_.reserve(values_.size());
    columns_.reserve(values_.size());
    for (Index j = 0; j < lower.outerSize(); ++j) {
      for (SparseMatrix::InnerIterator it(lower, j); it; ++it) {
        rows_.push_back(static_cast<int>(it.row()) + 1);
        columns_.push_back(static_cast<int>(j) + 1);
      }
    }
    mumps.nnz = static_cast<MUMPS_INT8>(values_.size());
    mumps.irn = rows_.data();
    mumps.jcn = columns_.data();
    mumps.a = values_.data();
  }

 private:
  std::vector<int> rows_, columns_;
  std::vector<double> values_;
};

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
  m.control(14) = kind == Kind::definite ? without_pivoting : with_pivoting;
  m.control(31) = keep == Keep::counts ? 1 : 0;
  std::vector<int> places = order;
  for (int& position : places) ++position;
  const Entries entries(pattern, m.mumps);
  m.mumps.n = static_cast<int>(size_);
  m.mumps.perm_in = places.data();
  m.run(job_analyse);
  if (m.status() < 0)
    throw TooLarge(
        fmt::format("the matrix of order {} could not be analysed for factorisation (MUMPS {}, {})", size_, m.status(), m.mumps.infog[1]));
}

SymmetricFactor::~SymmetricFactor() { of_->run(job_end); }

double SymmetricFactor::megabytes() const { return of_->mumps.infog[16]; }

double SymmetricFactor::megabytes_beside_files() const { return of_->mumps.infog[26]; }

double SymmetricFactor::megabytes_in_files() const { return entries() * bytes_an_entry / megabyte; }

double SymmetricFactor::entries() const {
  const int n = of_->mumps.infog[2];
  return n >= 0 ? n : -1e6 * n;  // in millions where it is large
}

// Once for all matrices of the pattern, of which each takes the place of the one before it.
void SymmetricFactor::choose_place() {
  if (placed_) return;
  placed_ = true;
  constexpr double small = 100;  // megabytes that nobody asks for
  if (factor_memory().most == unlimited && megabytes() < small) return;
  constexpr double share = 0.6;  // the rest is for other factors, and for vectors
  const double left = memory_left(megabytes() * megabyte / share) / megabyte;
  in_files_ = keep_ == Keep::factors && megabytes() > share * left;
  const double needed = in_files_ ? megabytes_beside_files() : megabytes();
  if (needed > left)
    throw TooLarge(
        fmt::format("factorising a matrix of order {} with {:.3g} entries in its factor takes {:.0f} MB{}, and {:.0f} MB are free{}", size_,
                    entries(), needed, in_files_ ? " even with the factor in files" : "", left,
                    factor_memory().most < unlimited ? " of those allowed (--memory)" : ""));
  if (!in_files_) return;
  Instance& m = *of_;
  const std::filesystem::path folder = scratch_folder();
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  if (error || folder.native().size() + 1 >= sizeof m.mumps.ooc_tmpdir)
    throw TooLarge(fmt::format("factors that are too large for memory go to {}, which {} (--scratch)", folder.string(),
                               error ? "is not there" : "has too long a name"));
  const double room = static_cast<double>(space.available) / megabyte;
  if (room < megabytes_in_files())
    throw TooLarge(fmt::format("a factor of {:.0f} MB is too large for memory, and {} has room for {:.0f} MB (--scratch)",
                               megabytes_in_files(), folder.string(), room));
  std::strcpy(m.mumps.ooc_tmpdir, folder.c_str());
  std::strcpy(m.mumps.ooc_prefix, "gyromode");
  m.control(22) = 1;
}

Index SymmetricFactor::factor(const SparseMatrix& lower) {
  assert(lower.nonZeros() == non_zeros_ && lower.cols() == size_);
  choose_place();
  Instance& m = *of_;
  const Entries entries(lower, m.mumps);
  constexpr int most_workspace = 1000;
  for (int percent = m.mumps.sym == 1 ? without_pivoting : with_pivoting;; percent *= 3) {
    m.control(14) = percent;
    m.run(job_factorise);
    if (!wants_more_workspace(m.status()) || percent > most_workspace) break;
  }
  if (m.status() == files_failed)
    throw TooLarge(fmt::format("a factor of {:.0f} MB could not be written to {} (--scratch)", megabytes_in_files(), m.mumps.ooc_tmpdir));
  if (m.status() == -13 || m.status() < -1000 || wants_more_workspace(m.status()))
    throw TooLarge(fmt::format(
        "factorising a matrix of order {} with {:.3g} entries in its factor takes some {} MB, which are not there (MUMPS {}, {})", size_,
        this->entries(), m.mumps.infog[16], m.status(), m.mumps.infog[1]));
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
