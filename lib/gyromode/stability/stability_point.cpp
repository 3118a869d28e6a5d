#include "gyromode/stability/stability_point.h"

namespace gyromode {

bool StabilityPoint::differs(const StabilityPoint& o) const {
  if (!decided() || !o.decided()) return false;
  if (stability != o.stability) return true;
  if (!balance.closed || !o.balance.closed) return false;
  return balance.real_pairs != o.balance.real_pairs || balance.quadruples != o.balance.quadruples ||
         balance.negative_energy != o.balance.negative_energy;
}

StabilityPoint stability_point(const ModesResult& r) {
  return {true, r.stability, r.index_balance, r.unstable.empty() ? 0 : r.unstable.front().growth_rate,
          r.stability == Stability::unknown ? r.coverage.reason : ""};
}

}  // namespace gyromode
