#pragma once

#include "gyromode/base/broken_law.h"
#include "gyromode/base/number_key.h"
#include "gyromode/read/toml_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

namespace gyromode::io {

/// Parts of models from their tables, by the numbers that each has: each_number(part, see), found by the type of the
/// part.

inline double required(const TomlTable& t, std::string_view key, Dimension d) {
  const auto value = t.quantity(key, d);
  if (!value) t.fail(fmt::format("key '{}' is missing: {} was expected", key, form_of(d)));
  return *value;
}

inline void read_several(const TomlTable& t, const NumberKey& k, std::span<double> to) {
  const std::vector<double> values = t.quantities(k.key, k.dimension, to.size(), k.form == NumberKey::Form::several_or_infinite);
  if (values.empty())
    t.fail(fmt::format("key '{}' is missing: {} values were expected, each {}", k.key, to.size() == 2 ? "two" : "three",
                       form_of(k.dimension)));
  std::copy(values.begin(), values.end(), to.begin());
}

// Only along the axis.
inline double read_height(const TomlTable& t, const NumberKey& k) {
  const std::vector<double> at = t.quantities(k.key, k.dimension, 3);
  if (at.empty()) t.fail(fmt::format("key '{}' is missing: three values were expected, each {}", k.key, form_of(k.dimension)));
  if (at[0] != 0 || at[1] != 0) {
    t.break_law(k.key, fmt::format("'{}' of a beam must be on axis 3, [0, 0, z]: it is [{:.6g}, {:.6g}, {:.6g}]; off the axis the "
                                   "centrifugal force bends a boom while it spins steadily",
                                   k.key, at[0], at[1], at[2]));
  }
  return at[2];
}

// A number for both, or two; 0 where it is left out and may be.
inline void read_one_or_two(const TomlTable& t, const NumberKey& k, std::span<double> to) {
  if (!t.has(k.key) && to[0] == 0 && to[1] == 0 && k.may_be_zero) return;
  if (t.is_array(k.key)) return read_several(t, k, to);
  to[0] = to[1] = required(t, k.key, k.dimension);
}

/// The numbers of a part from its table, into a part that has its defaults.
template <class Part>
void read_numbers(const TomlTable& t, Part& part) {
  each_number(part, [&](const NumberKey& k, std::span<double> to) {
    switch (k.form) {
      case NumberKey::Form::one: to[0] = required(t, k.key, k.dimension); break;
      case NumberKey::Form::optional: to[0] = t.quantity(k.key, k.dimension).value_or(to[0]); break;
      case NumberKey::Form::optional_or_infinite: to[0] = t.quantity(k.key, k.dimension, true).value_or(to[0]); break;
      case NumberKey::Form::one_or_two: read_one_or_two(t, k, to); break;
      case NumberKey::Form::on_axis_3: to[0] = read_height(t, k); break;
      case NumberKey::Form::several:
      case NumberKey::Form::several_or_infinite: read_several(t, k, to); break;
      case NumberKey::Form::symmetric: {
        const auto inertia = t.diagonal_or_matrix(k.key, k.dimension, 3);
        if (!inertia) t.fail(fmt::format("key '{}' is missing: three principal moments in kg m², or a 3 × 3 matrix, were expected", k.key));
        Eigen::Map<Matrix>(to.data(), 3, 3) = *inertia;
      }
    }
  });
}

/// A part from its table, which has no keys but those of its numbers and `more`.
template <class Part>
Part read_part(const TomlTable& t, std::initializer_list<std::string_view> more = {}, Part part = {}) {
  std::vector<std::string_view> keys(more);
  each_number(part, [&](const NumberKey& k, std::span<double>) { keys.push_back(k.key); });
  t.allow_only(keys);
  read_numbers(t, part);
  return part;
}

/// The part, where it keeps its laws; else LawBroken at the key.
template <class Part>
Part checked(const TomlTable& t, Part part) {
  if (const auto broken = broken_law(part)) t.break_law(broken->key, broken->law);
  return part;
}

}  // namespace gyromode::io
