#include "gyromode/write/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode::io {

namespace {

// Points at rest, and the lines through them. Where each mode takes them stands with the mode.
Json geometry(const ModesResult& r) {
  if (r.outlines.empty()) return nullptr;  // a model of matrices has none
  Json points = Json::array(), lines = Json::array();
  for (const ModelOutline& o : r.outlines) {
    Json through = Json::array();
    for (const Eigen::Vector3d& p : o.points) {
      through.push_back(points.size());
      points.push_back({p(0), p(1), p(2)});
    }
    lines.push_back({{"name", o.name}, {"points", std::move(through)}});
  }
  return {{"points", std::move(points)}, {"lines", std::move(lines)}, {"displacements", "modes[].displacements"}};
}

// The shapes as people read them, of the first coordinates.
void describe_shapes(const Model& model, const std::vector<Mode>& modes, Writer& w) {
  constexpr Index most_columns = 12;
  const Index shown = std::min<Index>(model.size(), most_columns);
  Table t{"", "", {{"", "#"}}, static_cast<Index>(modes.size()), {}};
  for (Index i = 0; i < shown; ++i) t.columns.push_back({"", model.labels()[static_cast<std::size_t>(i)]});
  t.row = [&](Index k) {
    std::vector<Cell> row{{k + 1, ""}};
    for (Index i = 0; i < shown; ++i) row.push_back({nullptr, complex_words(modes[static_cast<std::size_t>(k)].shape(i))});
    return row;
  };
  w.table(t);
  if (shown < model.size())
    w.paragraph(fmt::format("(the first {} of {} coordinates; all of them with --format json or csv)", shown, model.size()));
}

// Shapes of all modes, then of all growing motions, as one block: a row each.
void describe_block(const Model& model, const ModesResult& r, Writer& w) {
  Json re = Json::array(), im = Json::array(), fields = Json::array();
  const auto add = [&](const ComplexVector& shape) {
    const Vector real = shape.real(), imaginary = shape.imag();
    re.push_back(std::vector<double>(real.begin(), real.end()));
    im.push_back(std::vector<double>(imaginary.begin(), imaginary.end()));
  };
  for (const Mode& m : r.modes) {
    add(m.shape);
    fields.push_back(m.field.empty() ? Json(nullptr) : displacements(m.field));
  }
  for (const UnstableMode& u : r.unstable) {
    if (u.shape.size() > 0) add(u.shape);
  }
  w.fact("shapes", {{"labels", model.labels()}, {"re", std::move(re)}, {"im", std::move(im)}});
  if (!r.outlines.empty()) w.fact("geometry.displacements", std::move(fields));
}

}  // namespace

void describe(const Model& model, const ModesResult& r, const ModeDetails& details, Writer& w) {
  const Coverage& c = r.coverage;
  describe_class(model, r.structure, r.stiffness, !r.first_order, w);
  w.say("class", class_words(model, r.structure) + (r.first_order ? "" : "; " + stiffness_words(r.stiffness)));
  if (model.ignored) w.say("left out", in_words(*model.ignored));
  w.fact("structure.path", r.solver, "solver", r.solver);
  w.fact("stability", to_string(r.stability), "stability", stability_words(r.stability) + repaired_words(r.repairs));
  describe_balance(r.index_balance, w);
  describe_coverage(c, w.layout().unit, w);
  if (c.interrupted) w.fact("interrupted", true);
  describe_repairs(r.repairs, w);
  const bool shapes = !r.modes.empty() && r.modes.front().shape.size() > 0;
  const bool growing_shapes = !r.unstable.empty() && r.unstable.front().shape.size() > 0;
  const bool in_csv = w.for_csv() && (shapes || growing_shapes);
  Table modes = modes_table(model, "modes", r.modes, w, in_csv, details), unstable = unstable_table(model, r.unstable, w, in_csv);
  modes.csv = unstable.csv = true;
  w.table(modes);
  w.table(modes_lines(r.modes, details, w));
  if (shapes) describe_shapes(model, r.modes, w);
  w.table(unstable);
  w.fact("geometry", geometry(r));
  if (w.for_json() && w.version() == 2 && (shapes || growing_shapes)) describe_block(model, r, w);
}

void describe(const Model&, const CountResult& r, Writer& w) {
  w.fact("window", bounds(r.window), "window", window_words(r.window, w.layout().unit));
  w.fact("requested", bounds(r.requested));
  w.fact("count", r.count ? Json(*r.count) : Json(nullptr), "modes",
         r.count ? fmt::format("{}{}", *r.count, r.zero > 0 ? fmt::format(", {} of them at zero", r.zero) : "") : "not known");
  w.fact("signed", r.signed_count, "signed",
         fmt::format("{} (n₋(H) = {} at the lower end, {} at the upper)", r.signed_count, r.negative[0], r.negative[1]));
  w.fact("zero", r.zero);
  w.fact("negative", r.negative);
  w.fact("status", to_string(r.status), "status", std::string(to_string(r.status)));
  w.table({"",
           "",
           {{w.frequency_key("from")},
            {w.frequency_key("to")},
            {"count"},
            {"signed"},
            {"zero"},
            {"negative_from"},
            {"negative_to"},
            {"status"}},
           1,
           [&](Index) {
             return std::vector<Cell>{{w.frequency(r.window.a)},
                                      {w.frequency(r.window.b)},
                                      {r.count ? Json(*r.count) : no_value},
                                      {r.signed_count},
                                      {r.zero},
                                      {r.negative[0]},
                                      {r.negative[1]},
                                      {to_string(r.status)}};
           },
           true});
}

}  // namespace gyromode::io
