#include "gyromode/spectrum/verdict.h"

namespace gyromode {

std::string_view to_string(Stability s) {
  switch (s) {
    case Stability::stable: return "stable";
    case Stability::gyroscopically_stabilised: return "gyroscopically_stabilised";
    case Stability::unknown: return "unknown";
    case Stability::marginal: return "marginal";
    default: return "unstable";
  }
}

IndexBalance& IndexBalance::operator+=(const IndexBalance& other) {
  negative += other.negative;
  real_pairs += other.real_pairs;
  quadruples += other.quadruples;
  negative_energy += other.negative_energy;
  zero += other.zero;
  zero_negative += other.zero_negative;
  closed = closed && other.closed;
  return *this;
}

}  // namespace gyromode
