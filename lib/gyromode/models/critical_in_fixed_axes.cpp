#include "gyromode/models/critical_in_fixed_axes.h"

#include "gyromode/lapack/small.h"
#include "gyromode/modes/shape.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode {

namespace {

// Which part of a motion in turning axes has the frequency asked for in fixed ones.
enum class Part { with, against, unmoved };

// The part of every shape: p = (X + jY)/2 or q = (X − jY)/2 of every place, or the coordinates that no place names.
ComplexMatrix part_of(const ComplexMatrix& shapes, Part part, const std::vector<OrbitCoordinates>& places) {
  if (part == Part::unmoved) {
    std::vector<bool> named(static_cast<std::size_t>(shapes.rows()), false);
    for (const OrbitCoordinates& p : places) named[static_cast<std::size_t>(p.x)] = named[static_cast<std::size_t>(p.y)] = true;
    std::vector<Index> others;
    for (Index i = 0; i < shapes.rows(); ++i) {
      if (!named[static_cast<std::size_t>(i)]) others.push_back(i);
    }
    return shapes(others, Eigen::all);
  }
  const Complex j(0, part == Part::with ? 1 : -1);
  ComplexMatrix all(static_cast<Index>(places.size()), shapes.cols());
  for (Index k = 0; k < all.rows(); ++k) {
    const OrbitCoordinates& p = places[static_cast<std::size_t>(k)];
    all.row(k) = 0.5 * (shapes.row(p.x) + j * shapes.row(p.y));
  }
  return all;
}

// Of roots that coincide: combinations of their shapes that have the part, as many as it has dimensions.
std::vector<CriticalSpeed> with_part(const std::vector<CriticalSpeed>& cluster, Part part, const std::vector<OrbitCoordinates>& places) {
  constexpr double small = 1e-6;
  ComplexMatrix shapes(cluster.front().shape.size(), static_cast<Index>(cluster.size()));
  for (std::size_t k = 0; k < cluster.size(); ++k) shapes.col(static_cast<Index>(k)) = cluster[k].shape / cluster[k].shape.norm();
  const ComplexMatrix parts = part_of(shapes, part, places);
  std::vector<CriticalSpeed> kept;
  if (parts.rows() == 0) return kept;
  const Eigen::JacobiSVD<ComplexMatrix> svd(parts, Eigen::ComputeFullV);
  for (Index k = 0; k < svd.singularValues().size(); ++k) {
    if (!(svd.singularValues()(k) > small)) continue;
    CriticalSpeed c = cluster[static_cast<std::size_t>(kept.size())];
    if (cluster.size() > 1) c.shape = normalised(shapes * svd.matrixV().col(k));
    kept.push_back(std::move(c));
  }
  return kept;
}

void join(Coverage& whole, const Coverage& part, bool first) {
  if (first) {
    whole = part;
    return;
  }
  whole.window.b = std::min(whole.window.b, part.window.b);
  whole.found += part.found;
  whole.counted = whole.counted && part.counted ? std::optional(*whole.counted + *part.counted) : std::nullopt;
  if (part.status != CoverageStatus::complete && whole.status == CoverageStatus::complete) {
    whole.status = part.status;
    whole.reason = part.reason;
  }
}

}  // namespace

CriticalSpeeds critical_speeds_from_turning_axes(const ModelKind& model, const CriticalOptions& options) {
  const std::vector<OrbitCoordinates> places = model.orbits();
  const double m = options.order;
  CriticalSpeeds all;
  all.order = m;
  all.in_fixed_axes = true;
  bool first = true;
  const auto add = [&](double multiple, Part part, std::optional<Whirl> whirl) {
    CriticalOptions o = options;
    o.order = multiple;
    o.lowest.reset();
    CriticalSpeeds found = model.critical_speeds(o);
    all.not_physical += found.not_physical;
    Index left_out = 0;
    for (std::size_t k = 0, past; k < found.speeds.size(); k = past) {
      past = k + 1;
      while (past < found.speeds.size() && coincide(found.speeds[past - 1], found.speeds[past])) ++past;
      std::vector<CriticalSpeed> cluster(found.speeds.begin() + static_cast<std::ptrdiff_t>(k),
                                         found.speeds.begin() + static_cast<std::ptrdiff_t>(past));
      std::vector<CriticalSpeed> kept = places.empty() ? cluster : with_part(cluster, part, places);
      left_out += static_cast<Index>(cluster.size() - kept.size());
      for (CriticalSpeed& c : kept) {
        c.whirl = whirl;
        all.speeds.push_back(std::move(c));
      }
    }
    all.other_way += left_out;
    found.coverage.found -= left_out;
    if (found.coverage.counted) *found.coverage.counted -= left_out;
    join(all.coverage, found.coverage, first);
    first = false;
  };
  add(std::abs(m - 1), m < 1 ? Part::against : Part::with, m == 0 ? std::optional<Whirl>() : Whirl::forward);
  if (m > 0) add(m + 1, Part::against, Whirl::backward);
  if (!places.empty() && 2 * places.size() < static_cast<std::size_t>(model.size())) add(m, Part::unmoved, std::nullopt);
  if (places.empty() && all.coverage.status == CoverageStatus::complete) {
    all.coverage.status = CoverageStatus::not_counted;
    all.coverage.reason = "the model names no 'orbits': which roots go round with the axes, and which against, is not known";
  }
  std::stable_sort(all.speeds.begin(), all.speeds.end(), [](const CriticalSpeed& a, const CriticalSpeed& b) { return a.speed < b.speed; });
  if (options.lowest) keep_lowest(all, *options.lowest);
  return all;
}

}  // namespace gyromode
