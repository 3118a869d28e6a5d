// libFuzzer: whatever the bytes, parse_model() returns a model that keeps the laws or throws Unreadable or LawBroken,
// with one line of message. No file is read: matrix files are sought in a folder that does not exist.
#include "gyromode/base/error.h"
#include "gyromode/read/read_model.h"
#include "gyromode/models/matrices.h"
#include "gyromode/models/spacecraft_model.h"

#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

using gyromode::FirstOrderSystem;
using gyromode::LawBroken;
using gyromode::Matrix;
using gyromode::Model;
using gyromode::System;
using gyromode::Unreadable;

constexpr const char* name = "/gyromode-fuzz-folder-that-does-not-exist/fuzz.toml";

// Whether a string of the text may be a name outside that folder. The '/' of a unit ("rad/s") starts no name; an escape
// may spell one.
bool may_leave_the_folder(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char before = i > 0 ? text[i - 1] : '\0';
    const char after = i + 1 < text.size() ? text[i + 1] : '\0';
    if (text[i] == '/' && !(std::isalnum(static_cast<unsigned char>(before)) && after == 's')) return true;
    if (text[i] == '\\' && (after == 'u' || after == 'U' || after == 'x')) return true;
  }
  return false;
}

void require(bool holds) {
  if (!holds) std::abort();
}

void require_one_line(std::string_view message) { require(!message.empty() && message.find_first_of("\n\r") == std::string_view::npos); }

void require_laws(const System& s) {
  const Matrix &m = s.mass(), &g = s.gyroscopic(), &k = s.stiffness();
  require(m.allFinite() && g.allFinite() && k.allFinite());
  require(m == m.transpose() && g == -g.transpose() && k == k.transpose() && m.diagonal().minCoeff() > 0);
}

void require_laws(const FirstOrderSystem& s) {
  const Matrix &i = s.inertia(), &g = s.gyroscopic();
  require(i.allFinite() && g.allFinite() && i == i.transpose() && g == -g.transpose() && i.diagonal().minCoeff() > 0);
}

void require_laws(const gyromode::Spacecraft& s) {
  require(s.spin() > 0 && s.rigid().mass > 0 && s.rigid().second.allFinite());
  for (const auto& c : s.cables()) require(c.length > 0 && c.line_density > 0 && c.radius >= 0 && c.tip_mass >= 0);
}

void require_laws(const Model& model) {
  if (const System* system = model.body->second_order()) return require_laws(*system);
  if (const auto* first_order = dynamic_cast<const gyromode::FirstOrderModel*>(model.body.get()))
    return require_laws(first_order->system());
  require_laws(dynamic_cast<const gyromode::SpacecraftModel&>(*model.body).spacecraft());
}

std::string_view kind_of(const Model& model) {
  if (model.body->second_order()) return "matrices";
  return model.body->transcendental() ? "spacecraft" : "first_order";
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text{reinterpret_cast<const char*>(data), size};
  if (may_leave_the_folder(text)) return 0;
  try {
    const Model model = gyromode::parse_model(text, name);
    require_laws(model);
    require(model.size() > 0 && static_cast<gyromode::Index>(model.labels().size()) == model.size());
    require(model.kind == kind_of(model) && model.sha256.size() == 64);
  } catch (const Unreadable& error) {
    require_one_line(error.what());
  } catch (const LawBroken&) {
  }
  return 0;
}
