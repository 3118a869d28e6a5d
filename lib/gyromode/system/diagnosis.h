#pragma once

#include "gyromode/base/types.h"

#include <string>

namespace gyromode {

/// What matrices that break a law most probably are, and what to do, for people: a sentence each. Empty where nothing
/// is recognised. n × n, finite.

/// G ≠ −Gᵀ: damping (a positive semidefinite symmetric part), the system divided by its masses (M⁻¹G, M⁻¹K), G and K
/// exchanged.
std::string diagnosis_of_gyroscopic(const Matrix& mass, const Matrix& gyroscopic, const Matrix& stiffness);
/// K ≠ Kᵀ: one entry typed wrong, circulatory forces, or as above.
std::string diagnosis_of_stiffness(const Matrix& mass, const Matrix& gyroscopic, const Matrix& stiffness);
/// M ≠ Mᵀ, or M not positive definite: M and K exchanged, or as above.
std::string diagnosis_of_mass(const Matrix& mass, const Matrix& stiffness);

}  // namespace gyromode
