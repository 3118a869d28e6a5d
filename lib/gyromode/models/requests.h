#pragma once

#include "gyromode/appendage/parts.h"
#include "gyromode/base/progress.h"
#include "gyromode/motion/state.h"
#include "gyromode/spectrum/window.h"

#include <optional>
#include <string>
#include <vector>

namespace gyromode {

/// A motion over time that is asked for.
struct MotionRequest {
  State initial;                               ///< q and q̇ at t = 0, n each
  std::vector<Force> forces;                   ///< on the coordinates
  std::vector<BoomPoint> points;               ///< places on the booms of a spacecraft whose displacement is wanted too
  Vector times;                                ///< s, ≥ 0, ascending
  bool rates = false;                          ///< velocities are to be written as well
  Progress progress;                           ///< told times or frequencies
  std::vector<Index> chosen = {};              ///< coordinates that are wanted, ascending; empty: all
  Window window = {};                          ///< large sparse models: of the modes that the motion is made of
  std::optional<Index> lowest = std::nullopt;  ///< likewise: so many lowest ones
};

/// A response at steady frequencies that is asked for.
struct FrequencyRequest {
  Vector amplitude;                ///< f of f e^{jωt}, n
  Vector grid;                     ///< rad per unit of time, ascending
  Progress progress;               ///< told frequencies
  std::vector<Index> chosen = {};  ///< coordinates that are wanted, ascending; empty: all
};

/// A mass out of balance: mass times eccentricity at a place of a rotor.
struct Unbalance {
  std::string place;   ///< "disk2", "station4", "point_mass1", "bearing1", as of the model file from 1; matrices: the label of x
  double product = 0;  ///< kg m
  double phase = 0;    ///< rad, from x with the rotation
};

/// A response to unbalance that is asked for.
struct UnbalanceRequest {
  std::vector<Unbalance> masses;  ///< at least one
  Vector speeds;                  ///< rad per unit of time, ≥ 0, ascending
  Progress progress;              ///< told speeds
};

}  // namespace gyromode
