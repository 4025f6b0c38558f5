#include "core/mesh/measures.h"

namespace shapespline {

double enclosedVolume(const Positions& p, const std::vector<Triangle>& faces) {
  const Vec3 origin = p.empty() ? Vec3(Vec3::Zero()) : p.front();  // a nearby origin preserves digits of distant shapes
  double sum = 0;
  for (const Triangle& f : faces) sum += (p[f[0]] - origin).dot((p[f[1]] - origin).cross(p[f[2]] - origin));
  return sum / 6;
}

double surfaceArea(const Positions& p, const std::vector<Triangle>& faces) {
  double sum = 0;
  for (const Triangle& f : faces) sum += (p[f[1]] - p[f[0]]).cross(p[f[2]] - p[f[0]]).norm();
  return sum / 2;
}

}  // namespace shapespline
