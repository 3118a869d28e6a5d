#pragma once

#include "gyromode/base/types.h"

namespace gyromode {

/// A shape with its largest entry 1, the first of ties (within rounding); parts that are exactly zero stay so where the
/// largest entry is real or imaginary. Zero stays zero.
ComplexVector normalised(ComplexVector x);
/// What normalised() divides by.
Complex largest_entry(const ComplexVector& x);

}  // namespace gyromode
