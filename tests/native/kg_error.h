// The paper's error measure. The page uses web/study/kg-error.
#pragma once

#include <cmath>
#include <vector>

#include "core/base/centroid.h"
#include "core/base/types.h"

namespace shapespline {

/// The meaning of E(A) in the KG error.
enum class KgCentre {
  FrameCentroid,    ///< centroid of each frame (Karni & Gotsman 2004)
  SequenceAverage,  ///< average shape of all frames
};

inline Positions averageShape(const std::vector<Positions>& sequence) {
  Positions average(sequence.front().size(), Vec3::Zero());
  for (const Positions& frame : sequence)
    for (std::size_t v = 0; v < average.size(); ++v) average[v] += frame[v];
  for (Vec3& p : average) p /= static_cast<double>(sequence.size());
  return average;
}

/// Karni-Gotsman error of `other` relative to `sequence` (paper Eq. 7): 100 |A - A~|_F / |A - E(A)|_F. Both need the
/// same number of frames.
inline double kgError(const std::vector<Positions>& sequence, const std::vector<Positions>& other,
                      KgCentre centre = KgCentre::FrameCentroid) {
  const Positions average = centre == KgCentre::SequenceAverage ? averageShape(sequence) : Positions();
  double difference = 0, spread = 0;
  for (std::size_t k = 0; k < sequence.size(); ++k) {
    const Vec3 middle = centroidOf(sequence[k]);
    for (std::size_t v = 0; v < sequence[k].size(); ++v) {
      difference += (sequence[k][v] - other[k][v]).squaredNorm();
      spread += (sequence[k][v] - (average.empty() ? middle : average[v])).squaredNorm();
    }
  }
  return spread > 0 ? 100 * std::sqrt(difference / spread) : (difference > 0 ? INFINITY : 0);
}

}  // namespace shapespline
