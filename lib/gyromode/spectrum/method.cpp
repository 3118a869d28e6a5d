#include "gyromode/spectrum/method.h"

#include <array>
#include <utility>

namespace gyromode {

namespace {

constexpr std::array<std::pair<Method, std::string_view>, 7> words{{{Method::automatic, "auto"},
                                                                    {Method::quadrature, "quadrature"},
                                                                    {Method::hidden, "hidden"},
                                                                    {Method::general, "general"},
                                                                    {Method::companion, "first-order"},
                                                                    {Method::meirovitch, "symmetric-2n"},
                                                                    {Method::exact, "exact"}}};

}  // namespace

std::string_view to_string(Method method) { return words[static_cast<std::size_t>(method)].second; }

std::optional<Method> method_named(std::string_view word) {
  for (const auto& [method, its_word] : words) {
    if (its_word == word) return method;
  }
  return std::nullopt;
}

}  // namespace gyromode
