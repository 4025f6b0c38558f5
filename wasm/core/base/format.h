// Formats numbers for error messages.
#pragma once

#include <cstdint>
#include <string>

namespace shapespline {

/// An integer with thousands separated by commas: 5,261.
std::string grouped(std::int64_t number);

/// A number with at most six significant digits and no trailing zeros: 0.25, 1e-07.
std::string shortNumber(double number);

/// In whole degrees.
std::string angleText(double radians);

}  // namespace shapespline
