#include "gyromode/version.h"

namespace gyromode {

std::string_view version() { return GYROMODE_VERSION; }

}  // namespace gyromode
