#pragma once

#include <string>

namespace gyromode::io {

/// A number with the digits that an error of up to `error` leaves: the last printed place is the first that is no less
/// than twice the error, and at most `most` digits are printed. 3.14159 ± 0.002 is 3.14. After ≈, with two digits,
/// where the error is not known or leaves no digit. 0 ± 0 is 0.
std::string determined(double value, double error, int most = 15);

}  // namespace gyromode::io
