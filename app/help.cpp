#include "help.h"

#include "gyromode/base/lines.h"

#include <sstream>

namespace gyromode::app {

namespace {

std::string beside(const std::string& description, std::size_t column) {
  return wrapped_with_indent(description, line_columns - column, 0);
}

std::string paragraphs(const std::string& text) {
  std::string all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    all += (line.starts_with(' ') ? line : wrapped_with_indent(line, line_columns - 2, 2)) + "\n";
  return all;
}

}  // namespace

// The base class indents the lines of a description.
std::string HelpText::make_option_desc(const CLI::Option* option) const { return beside(option->get_description(), column); }

std::string HelpText::make_subcommand(const CLI::App* verb) const {
  std::ostringstream out;
  CLI::detail::format_help(out, verb->get_display_name(true), beside(verb->get_description(), column), column);
  return out.str();
}

std::string HelpText::make_description(const CLI::App* verb) const { return paragraphs(verb->get_description()); }
std::string HelpText::make_footer(const CLI::App* verb) const { return paragraphs(verb->get_footer()); }

}  // namespace gyromode::app
