#include "load.h"

#include "errors.h"
#include "input.h"

#include "gyromode/base/nearest.h"
#include "gyromode/base/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace gyromode::app {

namespace {

double number(const std::string& text, const std::string& whole, const std::string& option) {
  const Parsed p = parse_real(text);
  if (p.outcome != Parsed::ok) throw UsageError(fmt::format("{} {}: '{}' is no finite number", option, whole, text));
  return p.value;
}

void add_amplitudes(const std::string& list, const std::string& whole, const Labels& labels, Vector& to) {
  const std::vector<std::string_view> known(labels.begin(), labels.end());
  if (list.empty()) throw UsageError(fmt::format("--force {}: LABEL=VALUE is missing", whole));
  std::istringstream pieces(list);
  for (std::string piece; std::getline(pieces, piece, ',');) {
    const std::size_t equals = piece.rfind('=');
    if (equals == std::string::npos) throw UsageError(fmt::format("--force {}: '{}' where LABEL=VALUE was expected", whole, piece));
    const std::string label = piece.substr(0, equals);
    const auto at = std::find(labels.begin(), labels.end(), label);
    if (at == labels.end())
      throw UsageError(
          fmt::format("--force {}: '{}' is no coordinate of the model: did you mean '{}'?", whole, label, nearest(label, known)));
    to(at - labels.begin()) += number(piece.substr(equals + 1), whole, "--force");
  }
}

}  // namespace

std::vector<Force> forces_of(const std::vector<std::string>& texts, const Labels& labels) {
  std::vector<Force> forces;
  for (const std::string& text : texts) {
    const std::size_t colon = text.find(':');
    const std::string course = text.substr(0, colon);
    if (colon == std::string::npos || (course != "impulse" && course != "step" && course != "harmonic")) {
      throw UsageError(fmt::format("--force {}: impulse:LABEL=P, step:LABEL=F or harmonic:LABEL=F@W was expected", text));
    }
    Force f;
    f.amplitude = Vector::Zero(static_cast<Index>(labels.size()));
    std::string list = text.substr(colon + 1);
    f.course = course == "impulse" ? Force::Course::impulse : course == "step" ? Force::Course::step : Force::Course::harmonic;
    if (f.course == Force::Course::harmonic) {
      const std::size_t at = list.rfind('@');
      if (at == std::string::npos)
        throw UsageError(fmt::format("--force {}: the frequency of a harmonic force is missing: harmonic:LABEL=F@W, such as @5Hz", text));
      f.frequency = frequency_option("--force", list.substr(at + 1));
      if (!(f.frequency >= 0)) throw UsageError(fmt::format("--force {}: a frequency ≥ 0 was expected", text));
      list.resize(at);
    }
    add_amplitudes(list, text, labels, f.amplitude);
    forces.push_back(std::move(f));
  }
  return forces;
}

Vector amplitude_of(const std::vector<std::string>& texts, const Labels& labels) {
  Vector f = Vector::Zero(static_cast<Index>(labels.size()));
  for (const std::string& text : texts) add_amplitudes(text, text, labels, f);
  return f;
}

std::vector<BoomPoint> points_of(const std::vector<std::string>& texts) {
  std::vector<BoomPoint> points;
  for (const std::string& text : texts) {
    const std::size_t digits = text.find_first_of("0123456789"), at = text.find('@');
    const std::string kind = text.substr(0, digits);
    const bool mass = kind == "mass";
    std::int64_t which = 0;  // there is no part 0
    if (digits != std::string::npos) which = whole_number(text.substr(digits, at == std::string::npos ? at : at - digits)).value_or(0);
    if ((kind != "cable" && kind != "beam" && !mass) || which < 1 || mass != (at == std::string::npos)) {
      throw UsageError(fmt::format("--points {}: cable1@0.5, beam1@1 or mass1 was expected", text));
    }
    BoomPoint p{mass              ? BoomPoint::Part::mass
                : kind == "cable" ? BoomPoint::Part::cable
                                  : BoomPoint::Part::beam,
                static_cast<Index>(which), 1};
    if (!mass) p.along = number(text.substr(at + 1), text, "--points");
    points.push_back(p);
  }
  return points;
}

Vector frequency_grid(const std::string& option, const std::string& text) {
  const std::size_t first = text.find(':'), second = first == std::string::npos ? first : text.find(':', first + 1);
  if (second == std::string::npos) throw UsageError(fmt::format("{} {}: A:B:N was expected, such as 1Hz:50Hz:200", option, text));
  const double a = frequency_option(option, text.substr(0, first)),
               b = frequency_option(option, text.substr(first + 1, second - first - 1));
  const auto n = whole_number(text.substr(second + 1));
  if (!n || *n < 2 || *n > 1000000)
    throw UsageError(fmt::format("{} {}: a number of points from 2 to 1000000 was expected at the end", option, text));
  if (!(a >= 0) || !(b > a)) throw UsageError(fmt::format("{} {}: 0 ≤ A < B was expected", option, text));
  return Vector::LinSpaced(static_cast<Index>(*n), a, b);
}

}  // namespace gyromode::app
