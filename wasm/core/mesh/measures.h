// Measures of shapes and of sequences of shapes.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace shapespline {

/// Signed volume enclosed by the faces (divergence theorem): right for closed, consistently wound meshes.
double enclosedVolume(const Positions& positions, const std::vector<Triangle>& faces);
double surfaceArea(const Positions& positions, const std::vector<Triangle>& faces);

/// What E(A) in the KG error is.
enum class KgCentre {
  FrameCentroid,    ///< each frame's own centroid (Karni & Gotsman 2004)
  SequenceAverage,  ///< the average shape over all frames
};

/// Karni-Gotsman error of `other` against `sequence` (paper Eq. 7): 100 |A - A~|_F / |A - E(A)|_F. Same frame counts.
double kgError(const std::vector<Positions>& sequence, const std::vector<Positions>& other,
               KgCentre centre = KgCentre::FrameCentroid);

}  // namespace shapespline
