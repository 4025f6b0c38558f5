#include "core/log_branches.h"

#include "core/rotation.h"

namespace shapespline {

void appendNearest(std::vector<Vec3>& columns, const WeldedShape& shape, const Vec3& v) {
  const int column = static_cast<int>(columns.size());
  columns.push_back(column == 0 ? v : nearestRepresentative(v, columns[shape.before(column)]));
}

void addWinding(std::vector<Winding>& windings, int index, const Vec3& first, const Vec3& last) {
  const Vec3 closing = nearestRepresentative(first, last);
  if ((closing - first).squaredNorm() > 1) windings.push_back({index, closing - first});  // a whole turn or none
}

}  // namespace shapespline
