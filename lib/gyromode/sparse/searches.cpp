#include "gyromode/sparse/searches.h"

#include "gyromode/sparse/arnoldi_search.h"
#include "gyromode/sparse/deflated.h"
#include "gyromode/sparse/inverse_iteration.h"
#include "gyromode/sparse/inverses.h"
#include "gyromode/sparse/lanczos_search.h"

#include <algorithm>
#include <cmath>

namespace gyromode::sparse {

Searches::Searches(const SparseSystem& system, const Structure& structure)
    : system_(system),
      groups_(groups_of(structure, system.size())),
      norms_(norms_of(system)),
      stiffness_(system, groups_),
      free_(free_motions_of(system, groups_, stiffness_)),
      impedance_(system, groups_) {}

Index Searches::negative(Index block) const {
  return stiffness_.negative(block) - std::count(free_.t_across.begin(), free_.t_across.end(), stiffness_.across(block));
}

Index Searches::leading_block() const {
  for (Index b = 0; b < stiffness_.blocks(); ++b) {
    if (negative(b) == 0 && stiffness_.nullity(b) == 0) return b;
  }
  for (Index b = 0; b < stiffness_.blocks(); ++b) {
    if (negative(b) == 0) return b;
  }
  return -1;
}

// Below the softest motion at rest that is not free, where H is regular.
double Searches::lowest_shift() const {
  constexpr int attempts = 12;
  constexpr double regular = 1e3 * singular_margin, part = 0.6, less = 0.83;
  double next = infinity;
  for (Index b = 0; b < stiffness_.blocks(); ++b) next = std::min(next, stiffness_.next(b));
  if (next == infinity) next = std::pow(system_.gyroscopic_size(), 2);  // nothing but free motions
  if (next == 0) next = 1;
  double best = 0, sigma = part * std::sqrt(next), chosen = sigma;
  for (int k = 0; k < attempts && best <= regular; ++k, sigma *= less) {
    const double margin = impedance_.at(sigma)->margin;
    if (margin > best) {
      best = margin;
      chosen = sigma;
    }
  }
  return chosen;
}

std::unique_ptr<Search> Searches::about(double sigma, Index wanted) const {
  if (sigma == 0 && free_.nullity() > 0) return about(lowest_shift(), wanted);
  const Index first = leading_block();
  const bool lanczos = first >= 0 && !system_.singular_mass();
  if (lanczos) {
    std::unique_ptr<Inverse> inverse;
    if (sigma == 0 && groups_.partition) inverse = std::make_unique<InverseOfBlocks>(system_, groups_, stiffness_, first);
    if (sigma == 0 && !groups_.partition) inverse = std::make_unique<InverseOfMotion>(system_, stiffness_);
    if (sigma > 0 && groups_.partition) inverse = std::make_unique<InverseAtShift>(system_, groups_, impedance_.at(sigma), first);
    if (sigma > 0 && !groups_.partition) inverse = std::make_unique<InverseOfMotionAtShift>(system_, impedance_.at(sigma));
    if (free_.any()) inverse = std::make_unique<Deflated>(std::move(inverse), groups_, free_);
    return std::make_unique<LanczosSearch>(system_, groups_, norms_, free_, std::move(inverse), wanted);
  }
  Resolvent resolvent{sigma, {}};
  if (sigma == 0) {
    resolvent.solve = [this](const ComplexMatrix& r) {
      Matrix x = Matrix::Zero(r.rows(), r.cols());
      for (Index b = 0; b < stiffness_.blocks(); ++b) x += stiffness_.solve(b, r.real());
      return ComplexMatrix(x.cast<Complex>());
    };
  } else {
    resolvent.solve = [h = impedance_.at(sigma)](const ComplexMatrix& r) { return h->solve(r); };
  }
  return std::make_unique<ArnoldiSearch>(system_, groups_, norms_, free_, std::move(resolvent), wanted);
}

Search& Searches::about_zero(Index wanted) const {
  if (!at_zero_) at_zero_ = about(0, wanted);
  return *at_zero_;
}

std::string Searches::in_words() const {
  return leading_block() >= 0 ? "block Lanczos about K and shifts" : "block Krylov spaces about K and shifts, projected";
}

}  // namespace gyromode::sparse
