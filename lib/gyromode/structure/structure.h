#pragma once

#include "gyromode/structure/inertia_of_k.h"
#include "gyromode/structure/quadrature.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

#include <optional>
#include <string_view>
#include <vector>

namespace gyromode {

/// The class that decides which solver serves a system (theory §1–3).
enum class SystemClass { quadrature, hidden_quadrature, general };
std::string_view to_string(SystemClass c);

/// Whether a reversing symmetry is looked for where the coordinates show no partition. `by_cost`: at any order where K is not positive definite, as the general solver then costs five to fourteen times the
/// search; where K is, the general solver is faster than the search alone, and it is looked for up to order 256 only, where it takes hundredths of a second, so as to be known
/// (bench/results).
enum class HiddenSearch { by_cost, always, never };

/// What is known of a system before it is solved.
struct Structure {
  std::vector<Component> components;

  SystemClass system_class() const;                  ///< quadrature where every component has a partition; hidden where the others have a reversing symmetry
  std::vector<Index> in_phase() const;               ///< coordinates, ascending, over all components
  std::vector<Index> in_quadrature() const;
  std::optional<OddCycle> witness() const;           ///< the first component's odd cycle where there is no partition
};

Structure analyse(const System& system, HiddenSearch hidden = HiddenSearch::by_cost);
Structure analyse(const FirstOrderSystem& system);

}  // namespace gyromode
