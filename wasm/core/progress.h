// How far long work has come.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "core/out_of_line.h"

namespace shapespline {

/// Called with the fraction that is done, in [0, 1]; may be empty.
using FractionReport = std::function<void(double)>;

/// Reports item i of n, now and then: often enough for a progress bar, seldom enough to cost nothing.
inline void reportItem(const FractionReport& report, std::size_t i, std::size_t n) {
  if (report && i % 16384 == 0) report(static_cast<double>(i) / static_cast<double>(n));
}

inline void reportFraction(const FractionReport& report, double fraction) {
  if (report) report(fraction);
}

/// Calls work(begin, end) for one block of n items after the other, with a report before each. Every block is a call of its
/// own (out_of_line.h), so that long work does not stay in the browser's baseline compiler.
template <class Work>
void inBlocks(const FractionReport& report, std::size_t n, Work work) {
  constexpr std::size_t size = 16384;
  void (*call)(Work&, std::size_t, std::size_t) = [](Work& block, std::size_t begin, std::size_t end) { block(begin, end); };
  call = outOfLine(call);
  for (std::size_t begin = 0; begin < n; begin += size) {
    reportItem(report, begin, n);
    call(work, begin, std::min(n, begin + size));
  }
}

/// The part of a report that runs from one fraction of it to another. `report` must outlive the part.
inline FractionReport partOf(const FractionReport& report, double from, double to) {
  if (!report) return {};
  return [&report, from, to](double fraction) { report(from + (to - from) * fraction); };
}

}  // namespace shapespline
