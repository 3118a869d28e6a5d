#pragma once

#include "gyromode/base/broken_law.h"
#include "gyromode/base/labels.h"
#include "gyromode/rotor/parts.h"
#include "gyromode/system/spin_family.h"

#include <array>
#include <string>
#include <vector>

namespace gyromode {

/// Everything that a rotor is made of.
struct RotorParts {
  double speed = 0;                     ///< rad/s, of spools of ratio 1
  double axial_force = 0;               ///< N, tension positive, in every shaft
  std::vector<Material> materials;      ///< by name
  std::vector<ShaftSection> shafts;     ///< of each spool in order along the rotor
  std::vector<Disc> discs;              ///< on the shafts
  std::vector<Bearing> bearings;        ///< between shafts and ground, or two shafts
  std::vector<Support> supports;        ///< what is held
  std::vector<PointMass> point_masses;  ///< on the shafts
  std::vector<Spool> spools;            ///< empty: one, of speed ratio 1, from 0
};

/// The first law that a part breaks, or nothing.
std::optional<BrokenLaw> broken_law(const Material& material);
std::optional<BrokenLaw> broken_law(const ShaftSection& section);
std::optional<BrokenLaw> broken_law(const Disc& disc);
std::optional<BrokenLaw> broken_law(const Bearing& bearing);
std::optional<BrokenLaw> broken_law(const PointMass& mass);
std::optional<BrokenLaw> broken_law(const Spool& spool);

/// A place along a spool where elements meet, discs, bearings and supports are.
struct Station {
  std::size_t spool = 0;            ///< its number among the spools
  double position = 0;              ///< m
  std::array<Index, 4> coordinate;  ///< of x, y, θx, θy among those of the rotor; −1: held
};

/// Shafts that turn about the axis z, in fixed axes, with discs and bearings: displacements x and y and rotations θx
/// and θy of every station. One that exists is lawful: materials are known, parts are on their shaft. Stations are the
/// ends of sections and of their elements, and where discs, bearings, supports and masses are.
class Rotor {
 public:
  /// Throws LawBroken, naming the part ("disk 2") and what it breaks.
  explicit Rotor(RotorParts parts);

  const RotorParts& parts() const { return parts_; }                  ///< as given
  const std::vector<Spool>& spools() const { return spools_; }        ///< at least one
  const std::vector<Station>& stations() const { return stations_; }  ///< by spool, ascending
  /// x1, y1, theta_x1, theta_y1, …, of spools with names "inner.x1"; "bearing2.x" of housings.
  const Labels& labels() const { return labels_; }
  /// The number of coordinates.
  Index size() const { return static_cast<Index>(labels_.size()); }
  /// The station of a spool at a position, which must be one.
  const Station& station_at(std::size_t spool, double position) const;
  /// Coordinates x and y of the housing of a bearing; −1 where it has none.
  const std::array<Index, 2>& housing(std::size_t bearing) const { return housings_[bearing]; }
  /// @throws LawBroken where there is none of that name
  std::size_t spool_named(const std::string& name) const;
  /// @throws LawBroken likewise
  const Material& material_named(const std::string& name) const;
  double tolerance() const { return tolerance_; }  ///< m: positions nearer to each other are one

 private:
  void require_parts() const;
  void place_stations();
  std::vector<std::vector<double>> places_of_parts() const;
  void number_coordinates();

  RotorParts parts_;
  std::vector<Spool> spools_;
  std::vector<double> ends_;  // of every spool
  double tolerance_ = 0;
  std::vector<Station> stations_;
  std::vector<std::array<Index, 2>> housings_;
  Labels labels_;
};

/// Mass, gyroscopic matrix per speed, and stiffness: G(Ω) = ΩG₁, n × n, in fixed axes.
SpinFamily assembled(const Rotor& rotor);
/// The same of discs, point masses and bearings alone.
SpinFamily assembled_without_shafts(const Rotor& rotor);

}  // namespace gyromode
