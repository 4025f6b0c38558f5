// Regions of a shape with timings of their own: which timing each patch follows.
#pragma once

#include <memory>
#include <vector>

#include "core/base/status.h"
#include "core/sequence/encoded_shape.h"
#include "core/sequence/timing_region.h"
#include "core/spline/spline.h"

namespace shapespline {

/// Timings as parts of a curve: first that of the mean position, then those that patches follow.
struct RegionTimings {
  KeyTiming mean;  ///< over the area of the patches
  std::vector<KeyTiming> parts;
  std::shared_ptr<PatchParts> patches;  ///< indices of the parts after the first; rotatesWithMean is empty
};

/// The timings of the patches: the mean of the regions' timings over the area of the patch. A face in several regions
/// belongs to the first. whole: of all other faces. regions: not empty. LRI space must exist. Error: InvalidOption (a
/// face that the shape does not have, incomplete runs, two regions without faces, a wrong number of values per key).
Result<RegionTimings> regionTimings(const EncodedShape& encoded, const KeyTiming& whole,
                                    const std::vector<TimingRegion>& regions);

}  // namespace shapespline
