#pragma once

#include "gyromode/system/spin_family.h"

#include <string>
#include <vector>

namespace gyromode {

/// What in lawful matrices looks like a mistake all the same, for people: a sentence each, and a question rather than
/// a verdict. n × n.

/// A family in turning axes whose softening Ω²K₂ comes without Coriolis forces, or whose Coriolis forces are not those
/// of its masses: G₁ᵀM⁻¹G₁ = −4K₂ for masses that move across the spin axis, G₁ = 2MS, K₂ = MS², S the cross product
/// with the axis.
std::vector<std::string> doubts_on(const SpinFamily& family);
/// K indefinite and G = 0, so that nothing can stabilise it: softening without Coriolis forces?
std::vector<std::string> doubts_on(const System& system);
/// Labels that speak of millimetres: with N and kg frequencies come out too low by √1000.
std::vector<std::string> doubts_on(const Labels& labels);
/// Frequencies found, rad/s, against those known of the model, ascending: one factor between all that has a name (2π,
/// 60, √1000, …). Empty where they agree, or differ in no such way.
std::string doubt_on_unit(const std::vector<double>& found, const std::vector<double>& known);

}  // namespace gyromode
