#include "core/base/format.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shapespline {

namespace {

// Leading digits of a finite number without its sign. The first digit has the value of 10^exponent.
std::string leadingDigits(double number, int digits, int& exponent) {
  constexpr double log10of2 = 0.30102999566398120;
  int power = 1;
  std::frexp(number, &power);
  exponent = static_cast<int>(std::floor((power - 1) * log10of2));  // exact, or one too small
  if (number == 0) exponent = 0;
  const auto scaled = [&] {
    // Two steps, because 10^exponent alone may underflow.
    const int shift = digits - 1 - exponent;
    return std::nearbyint(number * std::pow(10.0, shift / 2) * std::pow(10.0, shift - shift / 2));
  };
  double whole = scaled();
  if (whole >= std::pow(10.0, digits)) {
    ++exponent;
    whole = scaled();
  }
  std::string text = std::to_string(static_cast<std::int64_t>(whole));
  return std::string(std::max(0, digits - static_cast<int>(text.size())), '0') + text;
}

}  // namespace

std::string grouped(std::int64_t number) {
  std::string digits = std::to_string(number);
  const int first = number < 0 ? 1 : 0;
  for (int at = static_cast<int>(digits.size()) - 3; at > first; at -= 3) digits.insert(at, 1, ',');
  return digits;
}

std::string shortNumber(double number) {
  constexpr int most = 6;
  if (!std::isfinite(number)) return std::isnan(number) ? "nan" : number < 0 ? "-inf" : "inf";
  int exponent = 0;
  std::string digits = leadingDigits(std::abs(number), most, exponent);
  const bool scientific = exponent < -4 || exponent >= most;
  const int before = scientific ? 1 : exponent + 1;  // position of the decimal point
  if (before <= 0) digits.insert(0, 1 - before, '0');
  const std::size_t whole = std::max(before, 1);
  digits.resize(std::max(whole, digits.find_last_not_of('0') + 1));
  if (digits.size() > whole) digits.insert(whole, 1, '.');
  if (std::signbit(number)) digits.insert(0, 1, '-');
  if (!scientific) return digits;
  const std::string power = std::to_string(std::abs(exponent));
  return digits + (exponent < 0 ? "e-" : "e+") + (power.size() < 2 ? "0" : "") + power;
}

std::string angleText(double radians) {
  const double degrees = radians * 180 / std::numbers::pi;
  return (std::abs(degrees) < 1e15 ? grouped(std::llround(degrees)) : shortNumber(degrees)) + " degrees";
}

}  // namespace shapespline
