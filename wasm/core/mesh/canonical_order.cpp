#include "core/mesh/canonical_order.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/base/permutation.h"
#include "core/base/sort_indices.h"
#include "core/mesh/mesh.h"

namespace shapespline {

namespace {

// Squared lengths are compared in steps of about 1e-7 of the pose's squared radius. This is far above rounding errors
// and far below any detail. The factor keeps steps away from round numbers, which are frequent in regular meshes.
constexpr double stepsPerUnit = 0x1p24 * 0.7390851332151607;

// Walks from sides with equal lengths are compared over this number of faces. A shape that differs only beyond them
// counts as symmetric.
constexpr std::size_t comparedFaces = 4096;
// Limit of such comparisons while the starts are searched, in addition to one per face of the mesh.
constexpr std::size_t comparedWalks = 64;

int inSteps(double squaredLength) {
  // squared lengths in valid poses stay below 4
  return squaredLength < 64 ? static_cast<int>(squaredLength * stepsPerUnit) : 1 << 30;
}

// Breadth-first walk over faces. Side 3 f + c runs from corner c of face f to the next corner.
class Walk {
 public:
  explicit Walk(const std::vector<int>& nextAlongEdge)
      : next_(nextAlongEdge), seen_(nextAlongEdge.size() / 3, 0), crossed_(nextAlongEdge.size(), 0) {}

  bool hasSeen(int face) const { return seen_[face] != 0; }
  /// The entry side of each face: the side across which the walk reached it.
  const std::vector<int>& entries() const { return queue_; }

  void begin(int side) { meet(side); }

  // Marks all faces as unseen.
  void forget() {
    for (int side : queue_) seen_[side / 3] = 0;
    for (int side : crowded_) crossed_[side] = 0;
    queue_.clear();
    crowded_.clear();
    served_ = 0;
  }

  // The entry side of the next face, or -1 at the end.
  int step() {
    if (served_ == queue_.size()) return -1;
    const int entry = queue_[served_++];
    for (int i = 0, side = entry; i < 3; ++i, side = sideAfter(side)) cross(side);
    return entry;
  }

  static int sideAfter(int side) { return side % 3 == 2 ? side - 2 : side + 1; }

 private:
  // If many sides share one edge, the first of them to be crossed visits all their faces.
  void cross(int side) {
    const bool crowded = next_[next_[side]] != side;
    if (crowded && crossed_[side]) return;
    for (int other = next_[side]; other != side; other = next_[other]) {
      meet(other);
      if (crowded) {
        crossed_[other] = 1;
        crowded_.push_back(other);
      }
    }
    if (crowded) {
      crossed_[side] = 1;
      crowded_.push_back(side);
    }
  }

  void meet(int side) {
    if (seen_[side / 3]) return;
    seen_[side / 3] = 1;
    queue_.push_back(side);
  }

  const std::vector<int>& next_;
  std::vector<char> seen_;
  std::vector<char> crossed_;  // sides along edges of three faces or more
  std::vector<int> crowded_;   // the marked sides in crossed_
  std::vector<int> queue_;
  std::size_t served_ = 0;
};

class Orderer {
 public:
  Orderer(std::vector<Triangle> faces, const std::vector<Positions>& poses) : faces_(std::move(faces)), poses_(poses) {}

  MeshOrder run(const FractionReport& onProgress) {
    measure();
    MeshOrder order;
    order.mirrored = isMirrored();
    if (order.mirrored)
      for (Triangle& t : faces_) std::swap(t[1], t[2]);
    reportFraction(onProgress, 0.05);
    next_ = nextAlongEdge(static_cast<int>(poses_.front().size()), faces_, partOf(onProgress, 0.05, 0.5));
    sortNonManifoldEdges();
    order.corner = walkAll(findFirst(partOf(onProgress, 0.5, 0.6)), partOf(onProgress, 0.6, 0.9));
    order.vertex = verticesMet(order.corner, partOf(onProgress, 0.9, 1));
    if (order.mirrored)
      for (int& corner : order.corner)
        if (corner % 3 > 0) corner += 3 - 2 * (corner % 3);
    return order;
  }

 private:
  // Farness of a vertex: its squared distance from the centroid relative to that of the farthest vertex, as a mean over
  // the poses.
  void measure() {
    std::vector<double> sum(poses_.front().size(), 0);
    for (const Positions& pose : poses_) {
      Vec3 mean = Vec3::Zero();
      for (const Vec3& p : pose) mean += (p - pose.front()) / static_cast<double>(pose.size());
      centroid_.push_back(pose.front() + mean);
      double radius = 0;
      for (const Vec3& p : pose) radius = std::max(radius, (p - centroid_.back()).norm());
      scale_.push_back(radius > 0 ? 1 / radius : 0);
      inBlocks({}, pose.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) sum[v] += squared(pose[v] - centroid_.back(), scale_.size() - 1);
      });
    }
    for (double s : sum) farness_.push_back(inSteps(s / static_cast<double>(poses_.size())));
  }

  double squared(const Vec3& difference, std::size_t pose) const { return (scale_[pose] * difference).squaredNorm(); }

  // The corners of a side's face, starting at the side's first corner.
  Triangle cornersFrom(int side) const {
    const Triangle& t = faces_[side / 3];
    const int c = side % 3;
    return {t[c], t[(c + 1) % 3], t[(c + 2) % 3]};
  }

  // Squared lengths in a pose: distances of the corners from the centroid, and sides of the face.
  std::array<double, 6> lengths(const Triangle& t, std::size_t pose) const {
    const Positions& p = poses_[pose];
    std::array<double, 6> result;
    for (int i = 0; i < 3; ++i) {
      result[i] = squared(p[t[i]] - centroid_[pose], pose);
      result[3 + i] = squared(p[t[(i + 1) % 3]] - p[t[i]], pose);
    }
    return result;
  }

  // Compares two sides by lengths in their faces that a rigid motion preserves: negative if s comes first, positive if
  // t does. Lengths in single poses are compared last, and only if `mayCompareByPose`.
  int compare(const Triangle& s, const Triangle& t, bool mayCompareByPose = true) const {
    for (int i = 0; i < 3; ++i)
      if (farness_[s[i]] != farness_[t[i]]) return farness_[s[i]] > farness_[t[i]] ? -1 : 1;
    std::array<double, 6> sumA{}, sumB{};
    int byPose = 0;
    for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
      const std::array<double, 6> x = lengths(s, pose), y = lengths(t, pose);
      for (int i = 0; i < 6; ++i) {
        sumA[i] += x[i];
        sumB[i] += y[i];
        if (mayCompareByPose && byPose == 0) byPose = inSteps(y[i]) - inSteps(x[i]);
      }
    }
    const double share = 1 / static_cast<double>(poses_.size());
    for (int i = 3; i < 6; ++i)
      if (const int difference = inSteps(share * sumB[i]) - inSteps(share * sumA[i]); difference != 0)
        return difference;
    return byPose;
  }

  // Whether the first of all reversed sides precedes the first of all sides.
  bool isMirrored() const {
    Triangle forward = faces_[0], backward = {forward[1], forward[0], forward[2]};
    for (int side = 0; side < 3 * static_cast<int>(faces_.size()); ++side) {
      const Triangle t = cornersFrom(side), turned = {t[1], t[0], t[2]};
      if (compare(t, forward, false) < 0) forward = t;
      if (compare(turned, backward, false) < 0) backward = turned;
    }
    return compare(backward, forward, false) < 0;
  }

  // Compares the walks that begin at two sides, face by face.
  int compareWalks(int a, int b) {
    while (walks_.size() < 2) walks_.emplace_back(next_);
    walks_[0].forget();
    walks_[1].forget();
    walks_[0].begin(a);
    walks_[1].begin(b);
    for (std::size_t i = 0; i < comparedFaces; ++i, ++compared_) {
      const int x = walks_[0].step(), y = walks_[1].step();
      if (x < 0 && y < 0) return 0;
      if (x < 0 || y < 0) return x < 0 ? 1 : -1;
      if (const int order = compare(cornersFrom(x), cornersFrom(y)); order != 0) return order;
      if (walks_[0].entries().size() != walks_[1].entries().size())
        return walks_[0].entries().size() > walks_[1].entries().size() ? -1 : 1;
    }
    return 0;
  }

  bool comesFirst(int a, int b, bool mayWalk) {
    int order = compare(cornersFrom(a), cornersFrom(b));
    if (order == 0 && mayWalk) order = compareWalks(a, b);
    return order != 0 ? order < 0 : a < b;
  }

  // Sorts three or more sides at one edge by their lengths.
  void sortNonManifoldEdges() {
    std::vector<int> sides;
    inBlocks({}, next_.size(), [&](std::size_t begin, std::size_t end) {
      for (int last = static_cast<int>(begin); last < static_cast<int>(end); ++last) {
        if (next_[last] >= last) continue;  // sides of an edge ascend, so each edge is handled at its last side
        sides = {last};
        for (int side = next_[last]; side != last; side = next_[side]) sides.push_back(side);
        if (sides.size() < 3) continue;
        sortIndices(sides, [&](int a, int b) { return comesFirst(a, b, false); });
        for (std::size_t i = 0; i < sides.size(); ++i) next_[sides[i]] = sides[(i + 1) % sides.size()];
      }
    });
  }

  bool mayWalk() const { return compared_ < faces_.size() + comparedWalks * comparedFaces; }

  // Updates `first` with any side of the face that precedes it.
  void takeFirst(int face, int& first) {
    for (int side = 3 * face; side < 3 * face + 3; ++side)
      if (side != first && comesFirst(side, first, mayWalk())) first = side;
  }

  int findFirst(const FractionReport& onProgress) {
    int first = 0;
    inBlocks(onProgress, faces_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) takeFirst(static_cast<int>(f), first);
    });
    return first;
  }

  // The first sides of the components that the walk has not seen, in reverse order.
  std::vector<int> findOthers(Walk walk) {
    std::vector<int> firsts;
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
      if (walk.hasSeen(f)) continue;
      walk.begin(3 * f);
      firsts.push_back(3 * f);
      for (int side; (side = walk.step()) >= 0;) takeFirst(side / 3, firsts.back());
    }
    sortIndices(firsts, [&](int a, int b) { return comesFirst(b, a, true); });
    return firsts;
  }

  // The entry side of each face, in walking order.
  std::vector<int> walkAll(int first, const FractionReport& onProgress) {
    Walk walk(next_);
    std::vector<int> starts;
    inBlocks(onProgress, faces_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (walk.step() >= 0) continue;
        if (i == 0) starts = {first};
        else if (starts.empty()) starts = findOthers(walk);
        walk.begin(starts.back());
        starts.pop_back();
        walk.step();
      }
    });
    return walk.entries();
  }

  std::vector<int> verticesMet(const std::vector<int>& sides, const FractionReport& onProgress) const {
    std::vector<int> vertices;
    vertices.reserve(farness_.size());
    std::vector<char> met(farness_.size(), 0);
    const auto meet = [&](int v) {
      if (!met[v]) {
        met[v] = 1;
        vertices.push_back(v);
      }
    };
    inBlocks(onProgress, sides.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        for (int v : cornersFrom(sides[i])) meet(v);
    });
    for (int v = 0; v < static_cast<int>(met.size()); ++v) meet(v);
    return vertices;
  }

  std::vector<Triangle> faces_;
  const std::vector<Positions>& poses_;
  std::vector<Vec3> centroid_;  // centroid of each pose
  std::vector<double> scale_;   // inverse radius of each pose; 0 for a pose of one point
  std::vector<int> farness_;    // farness of each vertex, in steps
  std::vector<int> next_;       // next side along the same edge, cyclically
  std::vector<Walk> walks_;     // two walks, created on demand
  std::size_t compared_ = 0;    // number of faces compared in walks
};

std::vector<int> inverseOf(const std::vector<int>& permutation) {
  assert(isPermutation(permutation));
  std::vector<int> inverse(permutation.size());
  for (std::size_t i = 0; i < permutation.size(); ++i) inverse[permutation[i]] = static_cast<int>(i);
  return inverse;
}

}  // namespace

std::vector<Triangle> MeshOrder::apply(const std::vector<Triangle>& faces) const {
  const std::vector<int> number = inverseOf(vertex);
  std::vector<Triangle> result;
  result.reserve(faces.size());
  inBlocks({}, corner.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Triangle& t = faces[corner[f] / 3];
      const int c = corner[f] % 3, next = mirrored ? 2 : 1;
      result.push_back({number[t[c]], number[t[(c + next) % 3]], number[t[(c + 3 - next) % 3]]});
    }
  });
  return result;
}

Positions MeshOrder::apply(const Positions& positions) const {
  Positions result;
  result.reserve(positions.size());
  inBlocks({}, vertex.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) result.push_back(positions[vertex[v]]);
  });
  return result;
}

Welding MeshOrder::apply(const Welding& welding) const {
  const std::vector<int> number = inverseOf(vertex);
  Welding result;
  result.count = welding.count;
  for (int w : welding.weldedOfRaw) result.weldedOfRaw.push_back(number[w]);
  for (int w : vertex) result.rawOfWelded.push_back(welding.rawOfWelded[w]);
  return result;
}

std::vector<int> MeshOrder::oldFaces() const {
  std::vector<int> faces;
  faces.reserve(corner.size());
  for (int first : corner) faces.push_back(first / 3);
  return faces;
}

MeshOrder canonicalOrder(const std::vector<Triangle>& faces, const std::vector<Positions>& poses,
                         const FractionReport& onProgress) {
  return Orderer(faces, poses).run(onProgress);
}

}  // namespace shapespline
