#include "core/spline/key_times.h"

#include <cmath>
#include <string>

#include "core/base/format.h"

namespace shapespline {

namespace {

// Share of the total time. For closer keys, the speeds between them have no significant digits.
constexpr double closestTimes = 1e-12;

// Seconds. For closer keys, speeds and accelerations exceed the range of numbers.
constexpr double shortestStep = 1e-30;

// Largest absolute time. A difference of 1e-6 is still representable there. Same limit in
// web/engine/api/option-table.ts.
constexpr double farthestTime = 1e9;

}  // namespace

Status validateTimes(const std::vector<double>& times, int keyCount) {
  if (static_cast<int>(times.size()) != keyCount)
    return Error{ErrorCode::TimeCountMismatch, "There are " + grouped(times.size()) + " key times for " +
                                                   grouped(keyCount) + " keys. Give one time per key."};
  for (int j = 0; j < keyCount; ++j) {
    if (!std::isfinite(times[j]))
      return Error{ErrorCode::NotFinite, "The time of key " + std::to_string(j + 1) + " is not a finite number.", j};
    if (std::abs(times[j]) > farthestTime)
      return Error{ErrorCode::TooLarge,
                   "Key " + std::to_string(j + 1) + " is at time " + shortNumber(times[j]) +
                       ". Times must be from -1,000,000,000 to 1,000,000,000. Choose a larger unit.",
                   j};
    const double step = j > 0 ? times[j] - times[j - 1] : 1;
    if (step > 0 && step < shortestStep)
      return Error{ErrorCode::TimesNotIncreasing,
                   "Key " + std::to_string(j + 1) + " follows key " + std::to_string(j) + " by " + shortNumber(step) +
                       " seconds. Move the keys at least " + shortNumber(shortestStep) + " seconds apart.",
                   j};
    if (step > 0 && j > 0 && !(step > closestTimes * (times.back() - times.front())))
      return Error{ErrorCode::TimesNotIncreasing,
                   "Key " + std::to_string(j + 1) + " follows key " + std::to_string(j) +
                       " by less than a trillionth of the total "
                       "time. Move the keys further apart.",
                   j};
    if (!(step > 0))
      return Error{ErrorCode::TimesNotIncreasing,
                   "Key " + std::to_string(j + 1) + " is at time " + shortNumber(times[j]) + ", not after key " +
                       std::to_string(j) + " at " + shortNumber(times[j - 1]) + ". Key times must increase.",
                   j};
  }
  return {};
}

std::vector<double> evenTimes(int keyCount) {
  std::vector<double> times(keyCount);
  for (int j = 0; j < keyCount; ++j) times[j] = keyCount > 1 ? static_cast<double>(j) / (keyCount - 1) : 0;
  return times;
}

}  // namespace shapespline
