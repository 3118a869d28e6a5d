#pragma once

#include "gyromode/base/number_key.h"
#include "gyromode/rotor/parts.h"

#include <span>

namespace gyromode {

/// Calls see(NumberKey, std::span<double>) for every number of a part, in the order of docs/model-files.md: the one
/// list of keys and dimensions, for readers and for parameters. Of a disc those of its geometry, where it has one.
template <class See>
void each_number(Material& m, See&& see) {
  see(NumberKey{"young", Dimension::modulus}, std::span(&m.young, 1));
  see(NumberKey{"shear", Dimension::modulus}, std::span(&m.shear, 1));
  see(NumberKey{"density", Dimension::density}, std::span(&m.density, 1));
}

template <class See>
void each_number(ShaftSection& s, See&& see) {
  see(NumberKey{"length", Dimension::length}, std::span(&s.length, 1));
  see(NumberKey{"outer_diameter", Dimension::length, NumberKey::Form::one_or_two}, std::span(s.outer_diameter, 2));
  see(NumberKey{"inner_diameter", Dimension::length, NumberKey::Form::one_or_two, true}, std::span(s.inner_diameter, 2));
  if (s.shear_coefficient) see(NumberKey{"shear_coefficient", Dimension::ratio}, std::span(&*s.shear_coefficient, 1));
}

template <class See>
void each_number(DiscGeometry& g, See&& see) {
  see(NumberKey{"width", Dimension::length}, std::span(&g.width, 1));
  see(NumberKey{"inner_diameter", Dimension::length, NumberKey::Form::optional}, std::span(&g.inner_diameter, 1));
  see(NumberKey{"outer_diameter", Dimension::length}, std::span(&g.outer_diameter, 1));
}

template <class See>
void each_number(Disc& d, See&& see) {
  see(NumberKey{"position", Dimension::length}, std::span(&d.position, 1));
  see(NumberKey{"offset", Dimension::length, NumberKey::Form::optional}, std::span(&d.offset, 1));
  if (d.geometry) return each_number(*d.geometry, see);
  see(NumberKey{"mass", Dimension::mass}, std::span(&d.mass, 1));
  see(NumberKey{"polar_inertia", Dimension::inertia, NumberKey::Form::optional}, std::span(&d.polar_inertia, 1));
  see(NumberKey{"diametral_inertia", Dimension::inertia, NumberKey::Form::optional}, std::span(&d.diametral_inertia, 1));
}

template <class See>
void each_number(PointMass& m, See&& see) {
  see(NumberKey{"position", Dimension::length}, std::span(&m.position, 1));
  see(NumberKey{"mass", Dimension::mass}, std::span(&m.mass, 1));
}

template <class See>
void each_number(Bearing& b, See&& see) {
  const auto spring = NumberKey::Form::optional_or_infinite;
  see(NumberKey{"position", Dimension::length}, std::span(&b.position, 1));
  see(NumberKey{"kxx", Dimension::stiffness, spring}, std::span(&b.kxx, 1));
  see(NumberKey{"kyy", Dimension::stiffness, spring}, std::span(&b.kyy, 1));
  see(NumberKey{"kxy", Dimension::stiffness, NumberKey::Form::optional}, std::span(&b.kxy, 1));
  see(NumberKey{"tilt_xx", Dimension::tilt_stiffness, spring}, std::span(&b.tilt_xx, 1));
  see(NumberKey{"tilt_yy", Dimension::tilt_stiffness, spring}, std::span(&b.tilt_yy, 1));
  see(NumberKey{"tilt_xy", Dimension::tilt_stiffness, NumberKey::Form::optional}, std::span(&b.tilt_xy, 1));
  see(NumberKey{"housing_mass", Dimension::mass, NumberKey::Form::optional}, std::span(&b.housing_mass, 1));
  see(NumberKey{"housing_kxx", Dimension::stiffness, NumberKey::Form::optional}, std::span(&b.housing_kxx, 1));
  see(NumberKey{"housing_kyy", Dimension::stiffness, NumberKey::Form::optional}, std::span(&b.housing_kyy, 1));
}

template <class See>
void each_number(Support& s, See&& see) {
  see(NumberKey{"position", Dimension::length}, std::span(&s.position, 1));
}

template <class See>
void each_number(Spool& s, See&& see) {
  see(NumberKey{"speed_ratio", Dimension::ratio, NumberKey::Form::optional}, std::span(&s.speed_ratio, 1));
  see(NumberKey{"start", Dimension::length, NumberKey::Form::optional}, std::span(&s.start, 1));
}

}  // namespace gyromode
