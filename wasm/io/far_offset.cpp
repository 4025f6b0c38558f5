#include "io/far_offset.h"

#include <algorithm>
#include <cmath>

#include "core/base/format.h"
#include "core/mesh/mesh.h"

namespace shapespline {

namespace {

// Up to this distance in diagonals, single precision rounds by a millionth of the diagonal.
constexpr double near = 16;
// Squares and products of larger numbers overflow single precision.
constexpr double maxCoordinate = 1e18;
// Share of a key's diagonal. Smaller roundings are invisible.
constexpr double visibleRounding = 1e-4;

struct Box {
  Vec3 low, high;

  Vec3 middle() const { return low + (high - low) / 2; }
  double diagonal() const { return (high - low).norm(); }
};

Box boxOf(std::span<const Key> keys) {
  Box box{keys[0].positions[0], keys[0].positions[0]};
  for (const Key& key : keys)
    for (const Vec3& p : key.positions) {
      box.low = box.low.cwiseMin(p);
      box.high = box.high.cwiseMax(p);
    }
  return box;
}

double diagonalOf(const Key& key) {
  const Positions* one = &key.positions;
  return boundingDiagonal({&one, 1});
}

bool havePositions(std::span<const Key> keys) {
  return !keys.empty() && std::none_of(keys.begin(), keys.end(), [](const Key& k) { return k.positions.empty(); });
}

// Whether all keys are close to the point.
bool areNear(const Box& box, const Vec3& point) {
  return (box.middle() - point).cwiseAbs().maxCoeff() <= near * box.diagonal();
}

Error tooLarge(const Key& key, int index, int vertex) {
  return {ErrorCode::TooLarge,
          key.name + " (key " + std::to_string(index + 1) + "): vertex " + grouped(vertex) + " is at (" +
              shortNumber(key.positions[vertex].x()) + ", " + shortNumber(key.positions[vertex].y()) + ", " +
              shortNumber(key.positions[vertex].z()) + "). Coordinates may be at most " + shortNumber(maxCoordinate) +
              ". Scale the mesh down, or give another unit if the format has none.",
          index, vertex};
}

Status checkReach(const std::vector<Key>& keys) {
  for (std::size_t j = 0; j < keys.size(); ++j) {
    const Positions& positions = keys[j].positions;
    for (std::size_t v = 0; v < positions.size(); ++v)
      if (std::isfinite(positions[v].sum()) && positions[v].cwiseAbs().maxCoeff() > maxCoordinate)
        return tooLarge(keys[j], static_cast<int>(j), static_cast<int>(v));
  }
  return {};
}

double largestRounding(const Positions& positions) {
  double largest = 0;
  for (const Vec3& p : positions) largest = std::max(largest, (p.cast<float>().cast<double>() - p).norm());
  return largest;
}

std::string roundedBy(double distance, double diagonal) {
  return "rounds its positions by up to " + shortNumber(distance) + " (" + shortNumber(100 * distance / diagonal) +
         " % of its size)";
}

}  // namespace

Vec3 chooseOffset(std::span<const Key> keys) {
  if (!havePositions(keys)) return Vec3::Zero();
  const Box box = boxOf(keys);
  const double diagonal = box.diagonal();
  if (!(diagonal > 0) || !std::isfinite(diagonal) || areNear(box, Vec3::Zero())) return Vec3::Zero();
  const double step = std::exp2(std::ceil(std::log2(diagonal)));
  return step * (box.middle() / step).array().round().matrix();
}

Status subtractOffset(Import& import, const ImportOptions& options) {
  std::vector<Key>& keys = import.keyframes.keys;
  if (Status reach = checkReach(keys); !reach) return reach;
  const bool saved = havePositions(keys) && import.offset != Vec3::Zero() && areNear(boxOf(keys), import.offset);
  if (options.offset) import.offset = *options.offset;
  else if (!saved) import.offset = chooseOffset(keys);
  if (import.offset != Vec3::Zero())
    for (Key& key : keys)
      for (Vec3& p : key.positions) p -= import.offset;
  return {};
}

void warnOfRounding(Import& import) {
  const std::vector<Key>& keys = import.keyframes.keys;
  for (std::size_t j = 0; j < keys.size(); ++j) {
    const double diagonal = diagonalOf(keys[j]), rounding = largestRounding(keys[j].positions);
    const int key = static_cast<int>(j);
    if (import.rounding > visibleRounding * diagonal) {
      import.warnings.push_back(
          {"rounded-positions",
           import.roundedIn + " stores positions far from the origin in single precision, which " +
               roundedBy(import.rounding, diagonal) +
               ". Export it nearer to the origin, put the distance into the node's translation (glTF), or use double "
               "precision (PLY, OBJ).",
           1, key});
      return;
    }
    if (rounding > visibleRounding * diagonal) {
      import.warnings.push_back({"distant-keys",
                                 "(" + keys[j].name + ") is so far from other keys that single precision " +
                                     roundedBy(rounding, diagonal) + ". Bring the keys closer together.",
                                 1,
                                 key,
                                 -1,
                                 {},
                                 "Key"});
      return;
    }
  }
}

}  // namespace shapespline
