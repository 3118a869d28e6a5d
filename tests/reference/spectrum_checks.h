#pragma once

#include "high_precision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <vector>

namespace gyromode::reference {

inline void PrintTo(Spectrum::Verdict verdict, std::ostream* out) {
  *out << std::vector{"stable", "gyroscopically stabilised", "marginal", "unstable"}.at(static_cast<std::size_t>(verdict));
}

/// n = (roots on the axis) + (real pairs) + 2 (quadruples) + ½ (zero roots)
inline void expect_complete(const Spectrum& s, Eigen::Index n) {
  EXPECT_EQ(2 * s.omega.size() + 2 * s.divergence.size() + 4 * s.flutter.size() + static_cast<std::size_t>(s.zero_roots),
            static_cast<std::size_t>(2 * n));
  EXPECT_EQ(s.omega.size(), s.energy_sign.size());
  EXPECT_TRUE(std::is_sorted(s.omega.begin(), s.omega.end()));
}

}  // namespace gyromode::reference
