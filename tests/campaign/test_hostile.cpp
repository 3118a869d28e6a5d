// Hostile systems (campaign/hostile_system.h) against exact truth: no false `complete`, no false verdict, no wrong sign
// or count, every frequency and growth rate within its bound, and hardly a refusal. GYROMODE_HOSTILE sets how many (10
// 000 in ./check, 100 000 with --full); GYROMODE_HOSTILE_FIRST the first seed.
#include "campaign/truth.h"

#include "gyromode/modes/modes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

namespace gyromode {
namespace {

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* asked = std::getenv(name);
  return asked ? std::strtoull(asked, nullptr, 10) : otherwise;
}

// A window of the system: ends between modes, on modes, at round numbers, open.
Window drawn_window(const support::Truth& t, std::mt19937_64& bits) {
  const auto end = [&]() -> double {
    const std::uint64_t kind = bits() % 4;
    if (t.modes.empty() || kind == 0) return std::ldexp(1 + static_cast<double>(bits() % 16), static_cast<int>(bits() % 12) - 6);
    const double omega = t.modes[bits() % t.modes.size()].omega;
    if (kind == 1) return omega;
    return omega * (1 + std::ldexp(static_cast<double>(bits() % 1024) - 512, -10));
  };
  Window w{bits() % 3 == 0 ? 0 : end(), end()};
  if (w.a > w.b) std::swap(w.a, w.b);
  if (!(w.a < w.b)) w = {0, w.b > 0 ? w.b : 1};
  return w;
}

// In parts, so that they can run side by side.
constexpr std::uint64_t parts = 4;
constexpr double well_conditioned = 1e-12;  // a change of this part of each matrix leaves the verdict
class HostileSystems : public testing::TestWithParam<std::uint64_t> {};

TEST_P(HostileSystems, NothingFalseIsClaimed) {
  const std::uint64_t count = from_environment("GYROMODE_HOSTILE", 2000) / parts,
                      first = from_environment("GYROMODE_HOSTILE_FIRST", 0) + GetParam() * count;
  const bool verbose = std::getenv("GYROMODE_HOSTILE_VERBOSE") != nullptr;
  std::uint64_t false_claims = 0, refused = 0, avoidable = 0, evaded = 0, twin_failed = 0;
  std::vector<double> tightness;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const support::HostileSystem h = support::hostile_system(seed);
    support::Truth truth;
    try {
      truth = support::truth_of(h);
    } catch (const std::logic_error& e) {
      ++twin_failed;
      continue;
    }
    std::mt19937_64 bits(seed);
    for (int window = 0; window < 2; ++window) {
      ModesOptions options;
      if (window > 0) options.window = drawn_window(truth, bits);
      support::Faults f;
      try {
        f = support::compare(h.system(), find_modes(h.system(), options), truth, window == 0 ? &tightness : nullptr);
      } catch (const std::exception& e) {
        f.false_verdict = true;
        f.text = std::string("throws: ") + e.what();
      }
      if (f.claims_falsely()) {
        ++false_claims;
        if (verbose || false_claims <= 20)
          ADD_FAILURE() << h.description << fmt::format(", window [{:.17g}, {:.17g}): ", options.window.a, options.window.b) << f.text;
      } else if (f.refused || f.evaded) {
        if (verbose) fmt::print("{}: {}, {:.2g} from another verdict\n", f.refused ? "refused" : "marginal", h.description, truth.distance);
      }
      refused += f.refused ? 1 : 0;
      avoidable += f.refused && truth.distance > well_conditioned ? 1 : 0;
      evaded += f.evaded ? 1 : 0;
    }
  }
  std::sort(tightness.begin(), tightness.end());
  fmt::print(
      "{} systems: {} false claims, {} refused, {} of them farther than {:g} from another verdict, {} marginal where the truth is decided, "
      "{} without truth, bound over error {:.3g} in the median, {:.3g} at 90 %\n",
      count, false_claims, refused, avoidable, well_conditioned, evaded, twin_failed,
      tightness.empty() ? 0 : tightness[tightness.size() / 2], tightness.empty() ? 0 : tightness[tightness.size() * 9 / 10]);
  EXPECT_EQ(false_claims, 0u);
  EXPECT_LE(refused, 2 + 2 * count / 1000);  // two windows a system
  EXPECT_LE(avoidable, 2 + 2 * count / 10000);
  ASSERT_FALSE(tightness.empty());
  EXPECT_LE(tightness[tightness.size() / 2], 100);
}
INSTANTIATE_TEST_SUITE_P(Parts, HostileSystems, testing::Range(std::uint64_t{0}, parts));

// Systems of rare kinds beyond the counts above: one whose masses are sums in null coordinates, where rounding is
// relative to their terms.
TEST(HostileSystem, NothingFalseIsClaimedOfRareKinds) {
  for (const std::uint64_t seed : {98523u}) {
    const support::HostileSystem h = support::hostile_system(seed);
    const support::Faults f = support::compare(h.system(), find_modes(h.system()), support::truth_of(h), nullptr);
    EXPECT_FALSE(f.claims_falsely() || f.refused) << h.description << ": " << f.text;
  }
}

}  // namespace
}  // namespace gyromode
