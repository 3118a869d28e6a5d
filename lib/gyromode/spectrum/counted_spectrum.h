#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/spectrum/inertia.h"
#include "gyromode/spectrum/result.h"

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace gyromode {

/// A root ω ≥ 0 of a CountedSpectrum.
struct CountedRoot {
  double omega = 0;
  double error = 0;         ///< the true root is in omega ± error
  int energy_sign = 1;      ///< 0 of zero roots, and where it cannot be told
  bool zero = false;        ///< a pair of zero roots (one, in first order)
  bool rigid_body = false;  ///< known by construction: not among those that --lowest counts
  std::string doubt;        ///< why it is no root, whatever the counts say, for people; empty where nothing speaks against it
};

/// Roots of a range, ascending, and what is known of each.
struct RootRange {
  std::vector<CountedRoot> roots;
  std::function<Mode(std::size_t root, bool with_shape)> mode;  ///< frequencies in rad per unit of time
  double all_below = 0;                                         ///< of lowest roots: all below that are listed, by count
  double known_from = 0, known_below = infinity;                ///< where work was stopped: the roots outside are not all known
};

/// What every engine leaves: the roots of a model with counts that are independent of them. Windows, their ends, the
/// lowest so many, coverage, counts and results are made of this and nothing else (certificate/, modes/). Frequencies
/// are in a unit of the engine's choice.
class CountedSpectrum {
 public:
  virtual ~CountedSpectrum() = default;

  /// ω = 1 in rad per unit of time.
  virtual double unit() const { return 1; }

  /// All roots, ascending, of an engine that finds them at once; null where roots are found by ranges.
  virtual const std::vector<CountedRoot>* all_roots() const { return nullptr; }
  /// The roots of [a, b), and perhaps some outside, zero roots too where a = 0. b may be infinite where there are
  /// finitely many.
  virtual RootRange roots(const Window& range, const Progress& progress = {}) const = 0;
  /// The same of an engine that finds roots with less work than it counts them at the ends of a window, which then are
  /// counted by what it knows. Nothing: the ends are counted first.
  virtual std::optional<RootRange> roots_before_counts(const Window& range [[maybe_unused]],
                                                       const Progress& progress [[maybe_unused]]) const {
    return std::nullopt;
  }
  /// The lowest `count` roots from range.a on that are no rigid-body ones, and some beyond, of an engine that finds
  /// them in that order; nothing of others.
  virtual std::optional<RootRange> lowest_roots(Index count [[maybe_unused]], const Window& range [[maybe_unused]],
                                                const Progress& progress [[maybe_unused]]) const {
    return std::nullopt;
  }
  /// For people, where a window without an end is asked for though there are infinitely many, or all are not to be had.
  virtual std::string why_an_end() const { return "a spacecraft with exact booms has infinitely many modes: "; }
  /// Whether there are finitely many; and then a frequency above all of them, where −ω²M has taken over.
  virtual bool finite() const { return true; }
  virtual double above_all() const = 0;
  /// By how much farther an end that is on a root is moved every time: a few where a count is cheap.
  virtual double outward() const { return 4; }
  /// Roots are followed no farther than this; `reach_reason` says why, for people.
  virtual double reach() const { return infinity; }
  virtual std::string reach_reason() const { return ""; }
  /// More roots than this are not listed at a time.
  virtual Index most_roots() const { return std::numeric_limits<Index>::max(); }
  /// How many roots are in (0, ω), by counts where roots are found by ranges.
  virtual Index below(double omega) const = 0;
  /// How many more roots a range holds than n₋ changes by: two for every one of negative energy that is known, one for
  /// each of an undecided pair (one + and one −).
  virtual Index missed_by_signs(const Window& range) const = 0;
  virtual Index zero_roots() const = 0;

  /// n₋(H(ω)), ω > 0, and n₋(H(0⁺)) (theory (T9), (T10)). At a root of energy sign κ it changes by κ · direction().
  virtual Inertia inertia_at(double omega) const = 0;
  virtual Index negative_at_zero() const = 0;
  virtual int direction() const { return 1; }

  /// The index balance, and why it is open, for people.
  virtual IndexBalance balance() const = 0;
  virtual std::string open_reason() const = 0;
  /// Whether every root was isolated by counts, or shown not to be listed twice: then counts between the ends can add
  /// nothing.
  virtual bool isolated() const = 0;

  /// All of a result that does not depend on the window.
  virtual void describe(ModesResult& result, bool with_shapes) const = 0;
};

/// The roots of `all` that are in the window.
std::vector<std::size_t> inside(const std::vector<CountedRoot>& all, const Window& window);

}  // namespace gyromode
