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

bool isHalfTurn(const Vec3& increment) { return increment.norm() > std::numbers::pi - halfTurnMargin; }

// The representative of a half turn in this direction. Without a direction, its largest coordinate is positive.
Vec3 directed(const Vec3& increment, const Vec3& direction) {
  if (!direction.isZero()) return nearestRepresentative(increment, direction);
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
      if (onGrid(largest) < least) {
        least = onGrid(largest);
        calmest = f;
      }
    }
    return calmest;
  }

  // The increment in world axes. Reversed keys and another reference pose change its sign at most, so the tree does not
  // depend on them.
  Vec3 inWorld(int step, int face) const {
    return out_.paths.key[posesOf(shape_, step).from][face] * out_.paths.increment[step][face];
  }

  // The largest relative rotation of two faces in a step.
  double cost(int f, int g) const {
    double largest = 0;
    for (const int s : lifted_)
      largest = std::max(largest, expQuaternion(inWorld(s, f)).angularDistance(expQuaternion(inWorld(s, g))));
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
    for (const int s : lifted_) {
      Vec3& d = out_.paths.increment[s][face];
      const Quaternion& q = out_.paths.key[posesOf(shape_, s).from][face];
      if (from >= 0) d = nearestRepresentative(d, q.conjugate() * inWorld(s, from));
    }
    if (from < 0) continueHalfTurns(face);
  }

  // An increment of about half a turn continues the direction of the clear increments before and after it.
  void continueHalfTurns(int face) {
    std::vector<Vec3> clear;
    for (int s = 0; s < steps_.closing(); ++s) {
      const Vec3& d = out_.paths.increment[s][face];
      clear.push_back(isHalfTurn(d) ? Vec3(Vec3::Zero()) : d);
    }
    const auto isClear = [](const Vec3& d) { return !d.isZero(); };
    for (auto here = clear.begin(); here != clear.end(); ++here) {
      Vec3& d = out_.paths.increment[here - clear.begin()][face];
      if (!isHalfTurn(d)) continue;
      const auto before = std::find_if(std::reverse_iterator(here), clear.rend(), isClear);
      const auto after = std::find_if(here, clear.end(), isClear);
      Vec3 sum = Vec3::Zero();
      if (before != clear.rend()) sum += *before;
      if (after != clear.end()) sum += *after;
      d = directed(d, sum);
    }
    Vec3& last = out_.paths.increment[steps_.closing()][face];
    if (isHalfTurn(last))
      last = directed(last, out_.paths.increment[steps_.closing() - 1][face] + out_.paths.increment[0][face]);
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
    AmbiguousFaces torn;
    double furthest = std::numbers::pi, area = 0;
    topology_.eachUsedFace([&](int f) {
      double largest = 0;
      for (const int g : topology_.graph.of(f))
        largest = std::max(largest, (inWorld(step, f) - inWorld(step, g)).norm());
      const double own = referenceFrame(shape_, f).area;
      area += own;
      if (largest <= std::numbers::pi) return;
      ++torn.count;
      torn.area += own;
      if (largest > furthest) {
        furthest = largest;
        torn.worst = f;
      }
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
