#pragma once

#include "gyromode/base/types.h"

#include <string_view>

namespace gyromode {

/// Of a symmetric matrix. `semidefinite` is positive semidefinite and singular.
enum class Definiteness { positive, semidefinite, indefinite };
std::string_view to_string(Definiteness d);

/// How many eigenvalues of K are negative, and how many are zero.
struct InertiaOfK {
  Index negative = 0;  ///< n₋(K)
  Index zero = 0;      ///< dim null(K)

  Definiteness definiteness() const;  ///< what they make of K
};

}  // namespace gyromode
