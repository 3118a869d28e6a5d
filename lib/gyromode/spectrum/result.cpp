#include "gyromode/spectrum/result.h"

namespace gyromode {

std::string_view to_string(ModeKind kind) {
  switch (kind) {
    case ModeKind::rigid_body: return "rigid_body";
    case ModeKind::local: return "local";
    default: return "vibration";
  }
}

std::string_view to_string(CoverageStatus status) {
  switch (status) {
    case CoverageStatus::complete: return "complete";
    case CoverageStatus::incomplete: return "incomplete";
    default: return "not_counted";
  }
}

std::string_view to_string(CountStatus status) {
  switch (status) {
    case CountStatus::exact: return "exact";
    case CountStatus::signed_only: return "signed_only";
    default: return "doubtful";
  }
}

}  // namespace gyromode
