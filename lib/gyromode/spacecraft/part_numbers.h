#pragma once

#include "gyromode/base/number_key.h"
#include "gyromode/spacecraft/spacecraft.h"

#include <span>

namespace gyromode {

/// Calls see(NumberKey, std::span<double>) for every number of a part, in the order of docs/model-files.md: the one
/// list of keys and dimensions, for readers and for parameters. Of a symmetric matrix the span has all nine entries.
template <class See>
void each_number(Body& b, See&& see) {
  see(NumberKey{"mass", Dimension::mass}, std::span(&b.mass, 1));
  see(NumberKey{"inertia", Dimension::inertia, NumberKey::Form::symmetric}, std::span(b.inertia.data(), 9));
}

template <class See>
void each_number(Cable& c, See&& see) {
  see(NumberKey{"azimuth", Dimension::angle}, std::span(&c.azimuth, 1));
  see(NumberKey{"radius", Dimension::length}, std::span(&c.radius, 1));
  see(NumberKey{"height", Dimension::length, NumberKey::Form::optional}, std::span(&c.height, 1));
  see(NumberKey{"length", Dimension::length}, std::span(&c.length, 1));
  see(NumberKey{"line_density", Dimension::line_density}, std::span(&c.line_density, 1));
  see(NumberKey{"tip_mass", Dimension::mass, NumberKey::Form::optional}, std::span(&c.tip_mass, 1));
}

template <class See>
void each_number(Beam& b, See&& see) {
  see(NumberKey{"root", Dimension::length, NumberKey::Form::on_axis_3}, std::span(&b.root_height, 1));
  see(NumberKey{"length", Dimension::length}, std::span(&b.length, 1));
  see(NumberKey{"line_density", Dimension::line_density}, std::span(&b.line_density, 1));
  see(NumberKey{"bending_stiffness", Dimension::bending_stiffness, NumberKey::Form::several}, std::span(b.bending_stiffness, 2));
  see(NumberKey{"tip_mass", Dimension::mass, NumberKey::Form::optional}, std::span(&b.tip_mass, 1));
}

template <class See>
void each_number(SpringMass& m, See&& see) {
  see(NumberKey{"position", Dimension::length, NumberKey::Form::several}, std::span(m.position.data(), 3));
  see(NumberKey{"mass", Dimension::mass}, std::span(&m.mass, 1));
  see(NumberKey{"stiffness", Dimension::stiffness, NumberKey::Form::several_or_infinite}, std::span(m.stiffness.data(), 3));
}

}  // namespace gyromode
