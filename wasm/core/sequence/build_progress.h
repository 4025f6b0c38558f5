// Stages of building LRI space, with their shares of the total time.
#pragma once

#include <algorithm>
#include <string_view>

namespace shapespline {

/// Converts the fraction of a stage to a fraction of the total, in [0, 1]. Shares come from measured runs.
inline double wholeProgress(std::string_view stage, double fraction, bool withGhost) {
  struct Stage {
    std::string_view name;
    int percent, percentWithGhost;
  };
  constexpr Stage stages[] = {
      {"simplifying", 0, 59}, {"matching", 0, 6}, {"encoding", 41, 12}, {"ordering", 18, 15}, {"factorising", 41, 8}};
  int before = 0;
  for (const Stage& s : stages) {
    const int percent = withGhost ? s.percentWithGhost : s.percent;
    if (s.name == stage) return std::min(1.0, (before + percent * fraction) / 100);
    before += percent;
  }
  return before / 100.0;
}

}  // namespace shapespline
