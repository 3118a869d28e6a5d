#pragma once

#include "gyromode/models/model_kind.h"

namespace gyromode {

/// Critical speeds of an order m of fixed axes, of a model in axes that turn: a motion e^{jωt} of these is one of ω + Ω
/// in fixed axes by its part that goes round with them, and of Ω − ω by the other. So ω = (m − 1)Ω of the first part
/// (of the second where m < 1) is forward whirl at mΩ there, and ω = (m + 1)Ω of the second is backward whirl. Roots
/// whose places lack the part are left out, and told. @throws as ModelKind::critical_speeds()
CriticalSpeeds critical_speeds_from_turning_axes(const ModelKind& model, const CriticalOptions& options);

}  // namespace gyromode
