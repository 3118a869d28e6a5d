#pragma once

#include "gyromode/read/read_model.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace gyromode::io {

/// A model file of which numbers are to be changed. A key is the dotted path of a number in the file, arrays counted from 0, [*] for every item: `spin`,
/// `body.inertia[2]`, `cable[*].length`, `stiffness[0][1]`; several with commas between are given the same value.
class VariedModel {
 public:
  /// Throws Unreadable where the file cannot be read or is no model.
  explicit VariedModel(const std::filesystem::path& file);
  VariedModel(std::string_view text, const std::filesystem::path& name);
  ~VariedModel();

  /// Throws InvalidArgument where the key leads to no number, with the nearest that does.
  void require_key(const std::string& key) const;
  /// The model with values[i] (SI) at keys[i]. Throws what reading a model throws: the values may make it unlawful.
  Model at(const std::vector<std::string>& keys, const std::vector<double>& values) const;

 private:
  struct Document;
  std::filesystem::path name_;
  std::unique_ptr<const Document> document_;
};

/// A value for a key: in SI, or with a unit of what the key measures.
std::optional<double> parse_value_of(const std::string& key, std::string_view text);

/// A number in SI or with any unit that model files know: "0.5", "10 rpm", "25 mm".
std::optional<double> parse_any_quantity(std::string_view text);

}  // namespace gyromode::io
