#pragma once

#include "gyromode/base/labels.h"

#include <string>
#include <vector>

namespace gyromode::app {

/// How people name coordinates on the command line: by label; in quotes where it holds a comma, an equals sign or
/// quotes ("a,b", quotes in it doubled); or by position, #1 … #n.

/// A list parted at the commas outside quotes.
std::vector<std::string> parted(const std::string& list);
/// The coordinate that `word` names, from 0. Throws UsageError, beginning with `context`, where there is none.
Index coordinate_named(const std::string& word, const Labels& labels, const std::string& context);
/// LABEL=VALUE, parted at the last equals sign outside quotes; `equals` false where there is none.
struct LabelAndValue {
  std::string label, value;
  bool equals = false;
};
LabelAndValue label_and_value(const std::string& piece);

}  // namespace gyromode::app
