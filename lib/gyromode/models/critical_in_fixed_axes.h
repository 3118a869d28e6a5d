#pragma once

#include "gyromode/models/model_kind.h"

namespace gyromode {

/// Critical speeds of an order m of fixed axes, of a model in axes that turn: a motion e^{jωt} of these is one of ω + Ω
/// in fixed axes by its part that goes round with them, of Ω − ω by the part against, and of ω by coordinates that no
/// orbit names, which are along or about the axis. So ω = (m − 1)Ω of the first part (of the second where m < 1) is
/// forward whirl at mΩ there, ω = (m + 1)Ω of the second backward whirl, and ω = mΩ what does not turn. Of roots that
/// coincide as many are kept as their combinations have the part; the others are told. Without orbits none is left out,
/// and the list is not called complete. @throws as ModelKind::critical_speeds()
CriticalSpeeds critical_speeds_from_turning_axes(const ModelKind& model, const CriticalOptions& options);

}  // namespace gyromode
