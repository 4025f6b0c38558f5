#include "core/sequence/torn_warnings.h"

#include <algorithm>
#include <string>

#include "core/base/format.h"

namespace shapespline {

namespace {

// Shares of the shape. Torn faces below them, by number or area, are slivers.
constexpr double minShare = 0.001;
constexpr int minCount = 4;

}  // namespace

std::vector<Warning> tornWarnings(const WeldedShape& shape, const RotationStrainSpace& space) {
  std::vector<Warning> warnings;
  const double least = std::max<double>(minCount, minShare * shape.faceCount());
  for (int s = 0; s + 1 < shape.keys; ++s) {
    const AmbiguousFaces& torn = space.tornFaces()[s];
    if (torn.worst < 0 || torn.count < least || torn.area < minShare) continue;
    warnings.push_back(
        {"torn-faces",
         grouped(torn.count) +
             " faces rotate by almost a full turn. Their rotation axes differ from those of adjacent faces, so the "
             "surface tears. Add a key in between, or choose the method 'lri'.",
         torn.count,
         s + 1,
         torn.worst,
         {},
         "Between"});
  }
  return warnings;
}

}  // namespace shapespline
