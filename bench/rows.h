#pragma once

#include "interleaved.h"

#include "gyromode/base/types.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gyromode::bench {

/// One interleaved run. Ratios are those of the first contestant, ours, to each of the others.
struct Row {
  std::string key;     ///< "a" … "k"
  std::string title;   ///< the system and its order
  std::string solver;  ///< what gyromode says of the solver it took
  double others = 0;   ///< share of the processors that other processes used meanwhile: what to distrust a row for
  std::vector<Timing> timings;
};

struct RowOptions {
  double n_scale = 1;       ///< multiplies every order: a quick run of 0.2 shows trends, not the numbers of the README
  int rounds = 7;           ///< timed rounds after one to warm up
  int process_rounds = 50;  ///< the same for row e
  std::filesystem::path program = "build/release/gyromode";
  std::filesystem::path model = "models/rotating_frame.toml";
};

/// n · n_scale, even, at least 8.
Index scaled_order(Index n, const RowOptions& options);

/// The rows of bench/README.md. Each builds its systems, runs and returns one Row or more.
std::vector<Row> quadrature_rows(const RowOptions& options);   ///< a
std::vector<Row> general_rows(const RowOptions& options);      ///< b
std::vector<Row> indefinite_rows(const RowOptions& options);   ///< c
std::vector<Row> certificate_rows(const RowOptions& options);  ///< d
std::vector<Row> process_rows(const RowOptions& options);      ///< e
std::vector<Row> spacecraft_rows(const RowOptions& options);   ///< f
std::vector<Row> hidden_rows(const RowOptions& options);       ///< g
std::vector<Row> certified_rows(const RowOptions& options);    ///< h
std::vector<Row> growth_rows(const RowOptions& options);       ///< i
std::vector<Row> sweep_rows(const RowOptions& options);        ///< j
std::vector<Row> campbell_rows(const RowOptions& options);     ///< k

}  // namespace gyromode::bench
