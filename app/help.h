#pragma once

#include <CLI/CLI.hpp>

namespace gyromode::app {

/// Help in lines of a terminal's width; lines of examples stay whole, to be copied.
class HelpText : public CLI::Formatter {
 public:
  HelpText() { column_width(column); }
  std::string make_option_desc(const CLI::Option* option) const override;
  std::string make_subcommand(const CLI::App* verb) const override;
  std::string make_description(const CLI::App* verb) const override;
  std::string make_footer(const CLI::App* verb) const override;

 private:
  static constexpr int column = 30;  // where descriptions begin
};

}  // namespace gyromode::app
