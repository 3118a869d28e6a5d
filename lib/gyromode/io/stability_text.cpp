#include "gyromode/io/result_text.h"
#include "gyromode/io/text_parts.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode::io {

std::string stability_text(const Model& model, const ModesResult& r, Format format) {
  std::string out = heading(format, model_line(model));
  out += fact(format, "stability", stability_words(r.stability));
  if (!r.first_order) {
    out += fact(format, "stiffness", stiffness_words(r.stiffness));
    out += fact(format, "balance", balance_words(r.index_balance));
  }
  if (std::isfinite(r.opposite_gap)) out += fact(format, "margin", fmt::format("nearest roots of opposite energy sign are {:.3g} apart, relative", r.opposite_gap));
  if (!r.negative_modes.empty()) out += "\nmodes of negative energy\n" + frequency_table(r.negative_modes, format);
  if (!r.unstable.empty()) out += "\n" + unstable_table(r.unstable, format);
  return out;
}

}  // namespace gyromode::io
