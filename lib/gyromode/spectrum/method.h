#pragma once

#include <optional>
#include <string_view>

namespace gyromode {

/// Which solver to use. `automatic` takes the best for the class; the others are refused (NotApplicable) where they do
/// not apply.
enum class Method {
  automatic,
  quadrature,  ///< real, of order n, by a partition into in phase and in quadrature
  hidden,      ///< the same in other coordinates, by a reversing symmetry
  general,     ///< real, with the Hamiltonian pairing kept
  companion,   ///< first-order form of order 2n, to compare with
  meirovitch,  ///< two symmetric matrices of order 2n (Meirovitch 1974), to compare with
  exact        ///< exact fields of booms; spacecraft
};

/// The word that the program has for it: auto, quadrature, hidden, general, first-order, symmetric-2n, exact.
std::string_view to_string(Method method);
/// The method of that word, or nothing.
std::optional<Method> method_named(std::string_view word);

}  // namespace gyromode
