#include "gyromode/spectrum/counted_spectrum.h"

namespace gyromode {

std::vector<std::size_t> inside(const std::vector<CountedRoot>& all, const Window& window) {
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (window.contains(all[i].omega)) positions.push_back(i);
  }
  return positions;
}

}  // namespace gyromode
