#include "load.h"

#include "coordinates.h"
#include "errors.h"
#include "input.h"

#include "gyromode/base/number.h"
#include "gyromode/base/quantity.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode::app {

namespace {

double number(const std::string& text, const std::string& whole, const std::string& option) {
  for (const Dimension d : {Dimension::force, Dimension::moment}) {
    if (const auto value = parse_quantity(text, d)) return *value;
  }
  throw UsageError(fmt::format("{} {}: '{}' is no finite number, alone or with N, kN, mN, N m", option, whole, text));
}

void add_amplitudes(const std::string& list, const std::string& whole, const Labels& labels, Vector& to) {
  if (list.empty()) throw UsageError(fmt::format("--force {}: LABEL=VALUE is missing", whole));
  for (const std::string& piece : parted(list)) {
    const LabelAndValue one = label_and_value(piece);
    if (!one.equals) throw UsageError(fmt::format("--force {}: '{}' where LABEL=VALUE was expected", whole, piece));
    to(coordinate_named(one.label, labels, "--force " + whole)) += number(one.value, whole, "--force");
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

std::vector<Unbalance> unbalances_of(const std::vector<std::string>& texts) {
  std::vector<Unbalance> all;
  for (const std::string& text : texts) {
    for (const std::string& piece : parted(text)) {
      const LabelAndValue one = label_and_value(piece);
      if (!one.equals || one.label.empty())
        throw UsageError(fmt::format("--unbalance {}: '{}' where PLACE=UNBALANCE was expected, such as disk2=1e-4", text, piece));
      const std::size_t at = one.value.rfind('@');
      const auto product = parse_quantity(one.value.substr(0, at), Dimension::unbalance);
      const auto phase = at == std::string::npos ? std::optional(0.0) : parse_quantity(one.value.substr(at + 1), Dimension::angle);
      if (!product) {
        throw UsageError(fmt::format("--unbalance {}: '{}' is no unbalance: {} was expected", text, one.value.substr(0, at),
                                     form_of(Dimension::unbalance)));
      }
      if (!phase)
        throw UsageError(
            fmt::format("--unbalance {}: '{}' is no phase: {} was expected", text, one.value.substr(at + 1), form_of(Dimension::angle)));
      all.push_back({one.label, *product, *phase});
    }
  }
  return all;
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

std::vector<Index> coordinates_of(const std::string& option, const std::string& list, const Labels& labels) {
  std::vector<Index> all;
  for (const std::string& word : parted(list)) all.push_back(coordinate_named(word, labels, option));
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

Labels labels_of(const std::string& list, const Labels& labels) {
  Labels chosen;
  for (const std::string& word : parted(list)) {
    const std::string& label = labels[static_cast<std::size_t>(coordinate_named(word, labels, "--keep"))];
    if (std::find(chosen.begin(), chosen.end(), label) != chosen.end()) throw UsageError(fmt::format("--keep: '{}' is given twice", label));
    chosen.push_back(label);
  }
  return chosen;
}

}  // namespace gyromode::app
