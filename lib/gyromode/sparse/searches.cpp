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

std::unique_ptr<Inverse> Searches::inverse_about(double sigma, Index first) const {
  std::unique_ptr<Inverse> inverse;
  if (sigma == 0 && groups_.partition) inverse = std::make_unique<InverseOfBlocks>(system_, groups_, stiffness_, first);
  if (sigma == 0 && !groups_.partition) inverse = std::make_unique<InverseOfMotion>(system_, stiffness_);
  if (sigma > 0 && groups_.partition) inverse = std::make_unique<InverseAtShift>(system_, groups_, impedance_.at(sigma), first);
  if (sigma > 0 && !groups_.partition) inverse = std::make_unique<InverseOfMotionAtShift>(system_, impedance_.at(sigma));
  if (!free_.any()) return inverse;
  TakenAway free = free_states(free_, groups_, *inverse);
  return std::make_unique<Deflated>(std::move(inverse), std::move(free));
}

// With K⁻¹ once more, which takes what is stiff out of them: rounding of ‖K‖ in their energy would be felt in that of
// all others.
void Searches::know(KnownMotions motions) {
  known_ = std::move(motions);
  known_states_ = {};
  release_zero();
  const bool decaying_unknown = !groups_.partition && !known_.unstable.empty();
  if (!known_.any() || leading_block() >= 0 || system_.singular_mass() || free_.negative > 0 || decaying_unknown) return;
  known_leads_ = 0;  // the block with the fewest negative eigenvalues
  for (Index b = 1; b < stiffness_.blocks(); ++b) {
    if (negative(b) < negative(known_leads_)) known_leads_ = b;
  }
  States states = states_of_known(known_, system_, groups_, known_leads_);
  if (free_.nullity() == 0) {
    const std::unique_ptr<Inverse> at_zero = inverse_about(0, known_leads_);
    const auto each = [&](const Matrix& a, bool in_order) {
      return !groups_.partition ? a : in_order ? at_zero->states(a) : at_zero->shapes(a);
    };
    const States finer = at_zero->apply({each(states.x, true), each(states.ex, true)});
    states = {each(finer.x, false), each(finer.ex, false)};
  }
  if (orthogonal_to(states, negative(known_leads_))) known_states_ = std::move(states);
}

bool Searches::leave_nothing_aside() const {
  if (known_states_.x.cols() == 0) return false;
  known_states_ = {};
  release_zero();
  return true;
}

std::unique_ptr<Inverse> Searches::inverse_beside_known(double sigma) const {
  if (known_states_.x.cols() == 0) return nullptr;
  std::unique_ptr<Inverse> inverse = inverse_about(sigma, known_leads_);
  States states = known_states_;
  if (groups_.partition) states = {inverse->states(states.x), inverse->states(states.ex)};
  return std::make_unique<Deflated>(std::move(inverse), *orthogonal_to(states, negative(known_leads_)));
}

std::unique_ptr<Search> Searches::about(double sigma, Index wanted) const {
  if (sigma == 0 && free_.nullity() > 0) return about(lowest_shift(), wanted);
  const Index first = leading_block();
  const auto lanczos = [&](std::unique_ptr<Inverse> inverse, std::vector<double> beside) {
    return std::make_unique<LanczosSearch>(system_, groups_, norms_, free_, std::move(inverse), std::move(beside), wanted);
  };
  if (first >= 0 && !system_.singular_mass()) return lanczos(inverse_about(sigma, first), {});
  if (auto beside = inverse_beside_known(sigma)) {
    std::vector<double> known;
    for (const RitzMode& m : known_.modes) known.push_back(m.omega);
    return std::make_unique<SearchBeside>(lanczos(std::move(beside), std::move(known)), known_);
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
  if (leading_block() >= 0) return "block Lanczos about K and shifts";
  return known_states_.x.cols() > 0 ? "block Lanczos about K and shifts, beside the motions that K has negative directions of"
                                    : "block Krylov spaces about K and shifts, projected";
}

}  // namespace gyromode::sparse
