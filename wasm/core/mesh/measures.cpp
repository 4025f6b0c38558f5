#include "core/mesh/measures.h"

#include <cmath>

#include "core/base/centroid.h"

namespace shapespline {

namespace {

Positions averageShape(const std::vector<Positions>& sequence) {
  Positions average(sequence.front().size(), Vec3::Zero());
  for (const Positions& frame : sequence)
    for (std::size_t v = 0; v < average.size(); ++v) average[v] += frame[v];
  for (Vec3& p : average) p /= static_cast<double>(sequence.size());
  return average;
}

}  // namespace

double enclosedVolume(const Positions& p, const std::vector<Triangle>& faces) {
  const Vec3 origin = p.empty() ? Vec3(Vec3::Zero()) : p.front();  // near the shape, so that far ones keep their digits
  double sum = 0;
  for (const Triangle& f : faces) sum += (p[f[0]] - origin).dot((p[f[1]] - origin).cross(p[f[2]] - origin));
  return sum / 6;
}

double surfaceArea(const Positions& p, const std::vector<Triangle>& faces) {
  double sum = 0;
  for (const Triangle& f : faces) sum += (p[f[1]] - p[f[0]]).cross(p[f[2]] - p[f[0]]).norm();
  return sum / 2;
}

double kgError(const std::vector<Positions>& sequence, const std::vector<Positions>& other, KgCentre centre) {
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
