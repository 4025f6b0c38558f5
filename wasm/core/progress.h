// How far long work has come.
#pragma once

#include <cstddef>
#include <functional>

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

/// A function of a block [begin, end) of items, and what it works on.
using BlockWork = void (*)(void* work, std::size_t begin, std::size_t end);

void inBlocks(const FractionReport& report, std::size_t n, BlockWork call, void* work);

/// Calls work(begin, end) for one block of n items after the other, with a report before each. Every block is a call of its
/// own (out_of_line.h), so that long work does not stay in the browser's baseline compiler.
template <class Work>
void inBlocks(const FractionReport& report, std::size_t n, Work work) {
  inBlocks(report, n, [](void* w, std::size_t begin, std::size_t end) { (*static_cast<Work*>(w))(begin, end); }, &work);
}

/// The part of a report that runs from one fraction of it to another. `report` must outlive the part.
inline FractionReport partOf(const FractionReport& report, double from, double to) {
  if (!report) return {};
  return [&report, from, to](double fraction) { report(from + (to - from) * fraction); };
}

}  // namespace shapespline
