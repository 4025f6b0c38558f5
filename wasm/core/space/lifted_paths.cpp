#include "core/space/lifted_paths.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

#include "core/patches/patch_coordinates.h"

namespace shapespline {

namespace {

// Within this of half a turn, rounding decides the sign of the principal logarithm.
constexpr double halfTurnMargin = 1e-3;

// An increment of about half a turn continues the direction of the previous one. Without a previous increment, its
// largest coordinate is positive. Other increments are unchanged.
Vec3 continuedHalfTurn(const Vec3& increment, const Vec3& before) {
  if (increment.norm() <= std::numbers::pi - halfTurnMargin) return increment;
  if (!before.isZero()) return nearestRepresentative(increment, before);
  int largest = 0;
  increment.cwiseAbs().maxCoeff(&largest);
  return increment[largest] < 0 ? nearestRepresentative(increment, -increment) : increment;
}

// Rounds costs to a grid, so rounding errors do not affect the tree.
double onGrid(double cost) { return std::nearbyint(cost * 0x1p20); }

class Lift {
 public:
  Lift(const WeldedShape& shape, const ShapeTopology& topology)
      : shape_(shape), topology_(topology), steps_{shape.keys}, open_(topology.turns) {}

  LiftedPaths run() {
    findPrincipalIncrements();
    for (const int component : topology_.tree.order) {
      const ComponentLink& link = topology_.tree.link[component];
      if (link.parent < 0) growFrom(calmestFace(component), -1);
      else growFrom(link.contactFace, link.anchorFace);
    }
    if (shape_.closing) closeOnFirstKey();
    for (int s = 0; s + 1 < shape_.keys; ++s) out_.torn.push_back(tornIn(s));
    return std::move(out_);
  }

 private:
  void findPrincipalIncrements() {
    RotationSplines& paths = out_.paths;
    const auto faces = static_cast<std::size_t>(shape_.faceCount());
    paths.key.assign(shape_.columns(), std::vector<Quaternion>(faces, Quaternion::Identity()));
    for (int c = 0; c < shape_.columns(); ++c)
      topology_.eachUsedFace([&](int f) { paths.key[c][f] = rotationOf(shape_, f, c).normalized(); });
    paths.increment.resize(steps_.count());
    for (int s = 0; s < steps_.count(); ++s) {
      const auto [from, to] = posesOf(shape_, s);
      if (from < 0 || s == steps_.turnedClosing()) continue;
      lifted_.push_back(s);
      paths.increment[s].assign(faces, Vec3::Zero());
      topology_.eachUsedFace([&, from = from, to = to](int f) { paths.increment[s][f] = between(from, to, f); });
    }
  }

  Vec3 between(int from, int to, int f) const {
    return logRotation(Quaternion(out_.paths.key[from][f].conjugate() * out_.paths.key[to][f]));
  }

  int calmestFace(int component) const {
    int calmest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int f = 0; f < shape_.faceCount(); ++f) {
      if (topology_.components.ofFace[f] != component) continue;
      double largest = 0;
      for (const int s : lifted_) largest = std::max(largest, out_.paths.increment[s][f].norm());
      if (onGrid(largest) < least) least = onGrid(largest), calmest = f;
    }
    return calmest;
  }

  // The largest relative rotation of two faces in a step.
  double cost(int f, int g) const {
    double largest = 0;
    for (const int s : lifted_) {
      const std::vector<Vec3>& d = out_.paths.increment[s];
      largest = std::max(largest, expQuaternion(d[f]).angularDistance(expQuaternion(d[g])));
    }
    return onGrid(0.05 + largest);
  }

  // Prim's algorithm. before: the face whose increments `root` should match, or -1.
  void growFrom(int root, int before) {
    struct Reached {
      double cost;
      int face, from;
      bool operator>(const Reached& other) const { return std::pair(cost, face) > std::pair(other.cost, other.face); }
    };
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
    queue.push({0, root, before});
    while (!queue.empty()) {
      const auto [_, face, from] = queue.top();
      queue.pop();
      if (!open_[face]) continue;
      open_[face] = 0;
      lift(face, from);
      for (const int next : topology_.graph.of(face))
        if (open_[next]) queue.push({cost(face, next), next, face});
    }
  }

  void lift(int face, int from) {
    Vec3 before = Vec3::Zero();
    for (const int s : lifted_) {
      Vec3& d = out_.paths.increment[s][face];
      if (from >= 0) d = nearestRepresentative(d, out_.paths.increment[s][from]);
      else if (s <= steps_.closing()) d = before = continuedHalfTurn(d, before);
    }
  }

  // The last key repeats the first, moved rigidly, so the loop continues from the previous key.
  void closeOnFirstKey() {
    const auto [from, to] = posesOf(shape_, steps_.turnedClosing());
    const std::vector<Vec3>& alike = out_.paths.increment[shape_.keys - 2];
    std::vector<Vec3>& closing = out_.paths.increment[steps_.turnedClosing()];
    closing.assign(alike.size(), Vec3::Zero());
    topology_.eachUsedFace([&, from = from, to = to](int f) {
      const Quaternion turned = shape_.closing->rotation * out_.paths.key[to][f];
      closing[f] =
          nearestRepresentative(logRotation(Quaternion(out_.paths.key[from][f].conjugate() * turned)), alike[f]);
    });
  }

  AmbiguousFaces tornIn(int step) const {
    const std::vector<Vec3>& d = out_.paths.increment[step];
    AmbiguousFaces torn;
    double furthest = std::numbers::pi, area = 0;
    topology_.eachUsedFace([&](int f) {
      double largest = 0;
      for (const int g : topology_.graph.of(f)) largest = std::max(largest, (d[f] - d[g]).norm());
      const double own = referenceFrame(shape_, f).area;
      area += own;
      if (largest <= std::numbers::pi) return;
      ++torn.count, torn.area += own;
      if (largest > furthest) furthest = largest, torn.worst = f;
    });
    torn.area /= area;
    return torn;
  }

  const WeldedShape& shape_;
  const ShapeTopology& topology_;
  KeySteps steps_;
  std::vector<char> open_;
  std::vector<int> lifted_;  // processed steps, in order
  LiftedPaths out_;
};

}  // namespace

LiftedPaths liftPaths(const WeldedShape& shape, const ShapeTopology& topology) { return Lift(shape, topology).run(); }

}  // namespace shapespline
