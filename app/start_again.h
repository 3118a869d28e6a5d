#pragma once

#include <string>
#include <vector>

namespace gyromode::app {

/// Where there is much to read in `files` (a model file counts with those that it names), starts this program anew with
/// large pages for large arrays, which the C library takes from the environment alone, before main(): on virtual
/// machines factorisations spend a quarter of their time on pages of 4 kB. What the user has set there stays. Returns
/// where there is nothing to gain.
void start_again_for_large(const std::vector<std::string>& files);

}  // namespace gyromode::app
