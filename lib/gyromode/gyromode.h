#pragma once

/// @file
/// All of gyromode that programs use: models from files or built in code, their modes, counts, verdicts, structure and
/// motion, and documents of them. docs/api.md shows ten short programs.

#include "gyromode/base/error.h"
#include "gyromode/base/labels.h"
#include "gyromode/base/progress.h"
#include "gyromode/base/quantity.h"
#include "gyromode/base/types.h"
#include "gyromode/formats/matrix_market.h"
#include "gyromode/html/report_page.h"
#include "gyromode/models/conversion.h"
#include "gyromode/models/model.h"
#include "gyromode/modes/modes.h"
#include "gyromode/motion/frequency_response.h"
#include "gyromode/motion/response.h"
#include "gyromode/read/read_model.h"
#include "gyromode/rotor/rotor.h"
#include "gyromode/spacecraft/spacecraft.h"
#include "gyromode/sparse/factor_memory.h"
#include "gyromode/stability/stability_map.h"
#include "gyromode/structure/realify.h"
#include "gyromode/structure/structure.h"
#include "gyromode/structure/symmetry_words.h"
#include "gyromode/sweep/critical_speeds.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/spin_family.h"
#include "gyromode/system/system.h"
#include "gyromode/version.h"
#include "gyromode/write/document.h"
