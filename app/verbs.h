#pragma once

#include <CLI/CLI.hpp>

namespace gyromode::app {

/// Each adds one verb to the program; its callback leaves the exit code in `code`.
void add_modes(CLI::App& program, int& code);
void add_structure(CLI::App& program, int& code);
void add_count(CLI::App& program, int& code);
void add_stability(CLI::App& program, int& code);
void add_campbell(CLI::App& program, int& code);
void add_critical(CLI::App& program, int& code);
void add_response(CLI::App& program, int& code);
void add_report(CLI::App& program, int& code);
void add_convert(CLI::App& program, int& code);

}  // namespace gyromode::app
