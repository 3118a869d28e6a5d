#include "gyromode/write/response_svg.h"

#include "gyromode/write/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gyromode::io {

namespace {

constexpr std::size_t most_curves = 6;

using Curve = std::vector<std::pair<double, double>>;

// Curves of amplitudes over [from, to], with lines where the response is unbounded.
struct Amplitudes {
  std::string title, across, up;
  double from, to;
  std::vector<std::pair<std::string, Curve>> curves;
  std::vector<double> resonances;
  std::string unit;  // of what is across

  std::string drawn() const {
    constexpr double most_decades = 8;
    double smallest = std::numeric_limits<double>::infinity(), largest = 0;
    for (const auto& [name, points] : curves) {
      for (const auto& [x, y] : points) {
        if (!(y > 0)) continue;
        smallest = std::min(smallest, y);
        largest = std::max(largest, y);
      }
    }
    const Chart::Axis y = decades(up, smallest, largest, most_decades);
    Chart chart(title, {across, from, to > from ? to : from + 1}, y);
    for (const double at : resonances) chart.curve({{at, y.from}, {at, y.to}}, {"resonance", "#888888", "1 3", 1.2});
    for (std::size_t k = 0; k < curves.size(); ++k) chart.curve(curves[k].second, numbered_style(k, curves[k].first));
    for (const double at : resonances) chart.label(at, y.to / std::pow(y.to / y.from, 0.06), fmt::format("{:.5g}", at));
    return chart.text();
  }
};

std::string with_unit(const std::string& what, FrequencyUnit unit) { return fmt::format("{} [{}]", what, to_string(unit)); }

}  // namespace

std::vector<std::size_t> highest(const std::vector<double>& peaks, std::size_t most) {
  std::vector<std::size_t> order(peaks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return peaks[a] > peaks[b]; });
  order.resize(std::min(order.size(), most));
  std::sort(order.begin(), order.end());
  return order;
}

std::vector<double> peaks_of(const UnbalanceReport& r) {
  std::vector<double> peaks(r.places.size(), 0);
  for (const SynchronousPoint& p : r.response.points) {
    for (std::size_t k = 0; k < r.places.size() && !p.resonance() && !p.added; ++k) peaks[k] = std::max(peaks[k], r.orbit(p, k).major);
  }
  return peaks;
}

std::string unbalance_svg(const Model& model, const UnbalanceReport& r, const Layout& l) {
  Amplitudes a{
      "Response to unbalance: " + model.title, with_unit("speed", l.spin_unit), "longer half axis of the orbit [m]", 0, 1, {}, {}, {}};
  const auto speed = [&](double omega) { return in_unit(omega, l.spin_unit); };
  if (!r.response.points.empty()) {
    a.from = speed(r.response.points.front().speed);
    a.to = speed(r.response.points.back().speed);
  }
  for (const std::size_t k : highest(peaks_of(r), most_curves)) {
    Curve curve;
    for (const SynchronousPoint& p : r.response.points)
      curve.emplace_back(speed(p.speed), p.resonance() ? std::nan("") : r.orbit(p, k).major);
    a.curves.emplace_back(r.places[k].name, std::move(curve));
  }
  for (const double omega : r.response.resonances()) a.resonances.push_back(speed(omega));
  return a.drawn();
}

std::string frequency_response_svg(const Model& model, const FrequencyReport& r, const Layout& l) {
  Amplitudes a{"Frequency response: " + model.title, with_unit("frequency", l.unit), "amplitude", 0, 1, {}, {}, {}};
  const auto shown = [&](double omega) { return in_unit(omega, l.unit); };
  const std::vector<FrequencyPoint>& points = r.response.points;
  if (!points.empty()) {
    a.from = shown(points.front().omega);
    a.to = shown(points.back().omega);
  }
  std::vector<double> peaks(r.labels.size(), 0);
  for (const FrequencyPoint& p : points) {
    for (std::size_t i = 0; i < peaks.size() && !p.resonance() && !p.added; ++i)
      peaks[i] = std::max(peaks[i], std::abs(p.q(static_cast<Index>(i))));
  }
  for (const std::size_t i : highest(peaks, most_curves)) {
    Curve curve;
    for (const FrequencyPoint& p : points)
      curve.emplace_back(shown(p.omega), p.resonance() ? std::nan("") : std::abs(p.q(static_cast<Index>(i))));
    a.curves.emplace_back(r.labels[i], std::move(curve));
  }
  for (const double omega : r.response.resonances()) a.resonances.push_back(shown(omega));
  return a.drawn();
}

std::string motion_svg(const Model& model, const ResponseReport& r) {
  const Vector& t = r.history.t;
  std::vector<double> peaks;
  for (Index i = 0; i < r.history.q.rows(); ++i) peaks.push_back(r.history.q.row(i).cwiseAbs().maxCoeff());
  const double reach = peaks.empty() ? 0 : *std::max_element(peaks.begin(), peaks.end());
  const double last = t(t.size() - 1), up = reach > 0 ? 1.05 * reach : 1;
  Chart chart("Motion: " + model.title, {"t [s]", t(0), last > t(0) ? last : t(0) + 1}, {"displacement", -up, up});
  const std::vector<std::size_t> shown = highest(peaks, most_curves);
  for (std::size_t k = 0; k < shown.size(); ++k) {
    Curve curve;
    for (Index s = 0; s < t.size(); ++s) curve.emplace_back(t(s), r.history.q(static_cast<Index>(shown[k]), s));
    chart.curve(curve, numbered_style(k, r.labels[shown[k]]));
  }
  return chart.text();
}

}  // namespace gyromode::io
