#include "core/ghost/simplify.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include "core/base/coarse_cost.h"
#include "core/base/sort_indices.h"
#include "core/ghost/collapse_mesh.h"
#include "core/ghost/face_budget.h"
#include "core/ghost/quadric.h"

namespace shapespline {

namespace {

// Weight of the squared distance from the original vertices, relative to the distance from the planes of their faces.
// It spreads the ghost's vertices over flat regions and keeps each vertex at the same point of the body in every pose.
constexpr double travelWeight = 1e-2;

// Weight of the squared distance from planes at the boundary, times the squared length of its edges.
constexpr double boundaryWeight = 1;

// Vertices with more faces only receive collapses.
constexpr int largestValence = 64;

constexpr int stepsPerReport = 2048;
constexpr int setUpsPerReport = 16384;
// Measured share of the work before the first collapse.
constexpr double setUpShare = 0.2;

// Limits for faces changed by a collapse: the cosine of the angle by which the normal rotates, and twice the resulting
// area over the squared longest edge. Later limits apply when no other collapse is left. The values are not round,
// because round values are frequent in regular meshes.
struct Limits {
  double cosine, flatness;
};
constexpr Limits limits[] = {{0.47, 0.093}, {0.17, 0.031}, {0.013, 0.0047}};

using Kind = CollapseMesh::Kind;

// A target vertex for a collapse. Ordered by cost, then by vertex.
struct Candidate {
  std::uint32_t cost = 0;
  int target = -1;
  bool operator<(const Candidate& o) const { return cost != o.cost ? cost < o.cost : target < o.target; }
};

// A vertex's best candidate in the queue. Ties go to vertices in a scattered order, so regular regions thin out evenly.
struct Entry {
  std::uint32_t cost;
  std::uint32_t scatter;
  int vertex;
  int version;
  bool operator<(const Entry& o) const {  // reversed, because the queue serves the greatest entry
    return cost != o.cost ? cost > o.cost : scatter > o.scatter;
  }
};

class Simplifier {
 public:
  Simplifier(const WeldedShape& shape, const ShapeTopology& topology, const SimplifyOptions& options,
             const FractionReport& onProgress)
      : shape_(shape),
        options_(options),
        onProgress_(onProgress),
        columns_(shape.columns()),
        componentOf_(shape.vertexCount(), -1),
        budget_(budgetFaces(shape, topology, options.targetFaces)),
        mesh_(shape.vertexCount(), facesToUse(topology)) {
    const std::size_t n = shape.vertexCount();
    position_.resize(n * columns_);
    for (std::size_t v = 0; v < n; ++v)
      for (int c = 0; c < columns_; ++c) position_[v * columns_ + c] = shape.poses[c][v];
    quadric_.resize(n * columns_);
    error_.assign(n, 0);
    version_.assign(n, 0);
    rejected_.resize(n);
    goneTo_.assign(n, -1);
    faceCount_ = mesh_.faceCount();
    onProgress_(setUpShare / 4);
    for (int f = 0; f < faceCount_; ++f) {
      addQuadrics(f);
      if (f % setUpsPerReport == 0) onProgress_(setUpShare * (1 + static_cast<double>(f) / faceCount_) / 4);
    }
  }

  GhostMesh run() {
    const int start = mesh_.faceCount(), n = shape_.vertexCount();
    bool first = true;
    for (const Limits& now : limits) {
      limits_ = now;
      queue_ = {};
      std::fill(rejected_.begin(), rejected_.end(), Candidate{});
      for (int v = 0; v < n; ++v) {
        push(v);
        if (first && v % setUpsPerReport == 0) onProgress_(setUpShare * (1 + static_cast<double>(v) / n) / 2);
      }
      first = false;
      for (int step = 1; mesh_.faceCount() > options_.targetFaces && !queue_.empty(); ++step) {
        serve();
        if (step % stepsPerReport == 0 && start > options_.targetFaces)
          onProgress_(setUpShare + (1 - setUpShare) * (start - mesh_.faceCount()) / (start - options_.targetFaces));
      }
      if (mesh_.faceCount() <= options_.targetFaces) break;
    }
    GhostMesh ghost = collect();
    onProgress_(1);
    return ghost;
  }

 private:
  // The faces of components with a budget, without duplicates.
  std::vector<Triangle> facesToUse(const ShapeTopology& topology) {
    onProgress_(0);
    std::vector<Triangle> faces;
    std::vector<int> component;
    for (int f = 0; f < shape_.faceCount(); ++f) {
      if (!topology.turns[f] || budget_.least[topology.components.ofFace[f]] == 0) continue;
      faces.push_back(shape_.faces[f]);
      component.push_back(topology.components.ofFace[f]);
      for (int v : shape_.faces[f]) componentOf_[v] = component.back();
    }
    const int m = static_cast<int>(faces.size());
    std::vector<Triangle> sorted = faces;
    for (Triangle& t : sorted) std::sort(t.begin(), t.end());
    std::vector<int> order(m);
    std::iota(order.begin(), order.end(), 0);
    sortIndices(order, [&](int a, int b) { return sorted[a] != sorted[b] ? sorted[a] < sorted[b] : a < b; });
    std::vector<char> repeated(m, 0);
    for (int i = 1; i < m; ++i) repeated[order[i]] = sorted[order[i]] == sorted[order[i - 1]];
    count_.assign(budget_.least.size(), 0);
    std::vector<Triangle> distinct;
    for (int f = 0; f < m; ++f)
      if (!repeated[f]) {
        distinct.push_back(faces[f]);
        ++count_[component[f]];
      }
    onProgress_(setUpShare / 8);
    return distinct;
  }

  const Vec3& position(int v, int column) const { return position_[static_cast<std::size_t>(v) * columns_ + column]; }
  Quadric& quadric(int v, int column) { return quadric_[static_cast<std::size_t>(v) * columns_ + column]; }

  void addQuadrics(int f) {
    const Triangle& t = mesh_.face(f);
    for (int c = 0; c < columns_; ++c) {
      const Vec3 cross = (position(t[1], c) - position(t[0], c)).cross(position(t[2], c) - position(t[0], c));
      const double third = cross.norm() / 6;
      const Vec3 normal = cross.normalized();
      for (int v : t) {
        quadric(v, c).addPlane(normal, third);
        quadric(v, c).addPoint(travelWeight * third);
      }
      for (int i = 0; i < 3; ++i) {
        const int a = t[i], b = t[(i + 1) % 3];
        if (mesh_.kind(a) == Kind::Inner || mesh_.kind(b) == Kind::Inner) continue;
        if (!onLine(a, b)) continue;
        const Vec3 edge = position(b, c) - position(a, c);
        const Vec3 across = edge.cross(normal).normalized();
        for (int v : {a, b}) quadric(v, c).addPlane(across, boundaryWeight * edge.squaredNorm());
      }
    }
  }

  bool onLine(int a, int b) {
    mesh_.ring(a, ring_);
    return std::any_of(ring_.begin(), ring_.end(), [&](const auto& n) { return n.vertex == b && n.onLine(); });
  }

  // Whether the target vertex moves.
  bool moves(int from, int to) const {
    return options_.optimalPlacement && mesh_.kind(from) == mesh_.kind(to) && mesh_.valence(to) <= largestValence;
  }

  double cost(int from, int to) {
    double sum = 0;
    if (!moves(from, to)) {
      for (int c = 0; c < columns_; ++c) sum += quadric(from, c).at(position(to, c) - position(from, c));
      return sum + error_[to];
    }
    for (int c = 0; c < columns_; ++c) {
      Quadric both = quadric(from, c).about(position(to, c) - position(from, c));
      both += quadric(to, c);
      sum += both.at(both.minimiser());
    }
    return sum;
  }

  // The cheapest candidate after the last rejected one.
  Candidate best(int v) {
    Candidate best;
    if (mesh_.kind(v) == Kind::Fixed || mesh_.valence(v) == 0 || mesh_.valence(v) > largestValence) return best;
    mesh_.ring(v, ring_);
    for (const auto& n : ring_) {
      if (mesh_.kind(v) == Kind::Line && !n.onLine()) continue;
      const Candidate candidate{coarse(cost(v, n.vertex)), n.vertex};
      if (rejected_[v].target >= 0 && !(rejected_[v] < candidate)) continue;
      if (best.target < 0 || candidate < best) best = candidate;
    }
    return best;
  }

  void push(int v) { push(v, best(v)); }
  void push(int v, const Candidate& candidate) {
    ++version_[v];
    if (candidate.target >= 0)
      queue_.push({candidate.cost, static_cast<std::uint32_t>(v) * 2654435761u, v, version_[v]});
  }

  // Processes the next vertex: collapses it, requeues it with its current cost, or drops it.
  // Not inlined, because a browser optimises a function only between calls.
  [[gnu::noinline]] void serve() {
    const Entry entry = queue_.top();
    queue_.pop();
    const int v = entry.vertex;
    if (entry.version != version_[v] || count_[componentOf_[v]] <= budget_.least[componentOf_[v]]) return;
    const Candidate candidate = best(v);
    if (candidate.target < 0) return;
    if (candidate.cost > entry.cost) return push(v, candidate);
    place(v, candidate.target);
    if (isLegal(v, candidate.target)) return collapse(v, candidate.target);
    rejected_[v] = candidate;
    push(v);
  }

  // Position of the target vertex after the collapse, in every pose.
  void place(int from, int to) {
    placed_.resize(columns_);
    for (int c = 0; c < columns_; ++c) {
      placed_[c] = position(to, c);
      if (!moves(from, to)) continue;
      Quadric both = quadric(from, c).about(position(to, c) - position(from, c));
      both += quadric(to, c);
      placed_[c] += both.minimiser();
    }
  }

  bool isLegal(int from, int to) {
    if (!mesh_.canCollapse(from, to)) return false;
    int gone = 0;
    bool fair = true;
    const auto check = [&](int moved, int other) {
      mesh_.eachFace(moved, [&](int f) {
        const Triangle& t = mesh_.face(f);
        const int i = t[0] == moved ? 0 : t[1] == moved ? 1 : 2;
        const int x = t[(i + 1) % 3], y = t[(i + 2) % 3];
        if (x == other || y == other) gone += moved == from;
        else fair = fair && staysFair(moved, x, y);
      });
    };
    check(from, to);
    if (moves(from, to)) check(to, from);
    return fair && count_[componentOf_[from]] - gone >= budget_.least[componentOf_[from]];
  }

  // Checks face (v, x, y) for the move of v to the collapsed position.
  bool staysFair(int v, int x, int y) const {
    for (int c = 0; c < columns_; ++c) {
      const Vec3 side = position(y, c) - position(x, c);
      const Vec3 before = position(x, c) - position(v, c), after = position(x, c) - placed_[c];
      const Vec3 normalBefore = before.cross(side), normalAfter = after.cross(side);
      const double dot = normalBefore.dot(normalAfter);
      const double squaredBefore = normalBefore.squaredNorm(), squaredAfter = normalAfter.squaredNorm();
      if (!(dot > 0) || dot * dot < limits_.cosine * limits_.cosine * squaredBefore * squaredAfter) return false;
      const auto longest = [&](const Vec3& a) {
        return std::max({a.squaredNorm(), side.squaredNorm(), (a + side).squaredNorm()});
      };
      const double longestAfter = longest(after), longestBefore = longest(before);
      // A thin face may stay thin.
      const bool thin = squaredAfter < limits_.flatness * limits_.flatness * longestAfter * longestAfter;
      if (thin && squaredAfter * longestBefore * longestBefore < 0.999 * squaredBefore * longestAfter * longestAfter)
        return false;
    }
    return true;
  }

  void collapse(int from, int to) {
    mesh_.ring(from, touched_);
    const bool moved = moves(from, to);
    if (moved) {
      mesh_.ring(to, ring_);
      touched_.insert(touched_.end(), ring_.begin(), ring_.end());
    }
    error_[to] = 0;
    for (int c = 0; c < columns_; ++c) {
      Quadric& sum = quadric(to, c);
      sum += quadric(from, c).about(position(to, c) - position(from, c));
      if (moved) sum = sum.about(placed_[c] - position(to, c));
      position_[static_cast<std::size_t>(to) * columns_ + c] = placed_[c];
      error_[to] += sum.c;
    }
    count_[componentOf_[from]] -= mesh_.collapse(from, to);
    goneTo_[from] = to;
    ++version_[from];
    for (const auto& n : touched_) rejected_[n.vertex] = {};
    for (const auto& n : touched_)
      if (n.vertex != from) push(n.vertex);
  }

  GhostMesh collect() {
    const int n = shape_.vertexCount();
    GhostMesh ghost;
    ghost.joinedComponents = budget_.joined;
    std::vector<int> number(n, -1), kept;
    for (int v = 0; v < n; ++v)
      if (mesh_.valence(v) > 0) {
        number[v] = static_cast<int>(kept.size());
        kept.push_back(v);
      }
    for (int f = 0; f < faceCount_; ++f)
      if (!mesh_.isGone(f)) {
        const Triangle& t = mesh_.face(f);
        ghost.faces.push_back({number[t[0]], number[t[1]], number[t[2]]});
      }
    for (int c = 0; c < columns_; ++c) {
      ghost.poses.emplace_back();
      for (int v : kept) ghost.poses.back().push_back(position(v, c));
    }
    ghost.ghostOf.resize(n);
    for (int v = 0; v < n; ++v) ghost.ghostOf[v] = number[lastOf(v)];
    nameVertices(ghost);
    return ghost;
  }

  int lastOf(int v) {
    int last = v;
    while (goneTo_[last] >= 0) last = goneTo_[last];
    while (goneTo_[v] >= 0) v = std::exchange(goneTo_[v], last);
    return last;
  }

  void nameVertices(GhostMesh& ghost) const {
    const Positions& reference = shape_.poses[shape_.reference];
    const Positions& at = ghost.poses[shape_.reference];
    std::vector<double> nearest(at.size(), std::numeric_limits<double>::infinity());
    ghost.vertexOf.assign(at.size(), -1);
    for (int v = 0; v < shape_.vertexCount(); ++v) {
      const int g = ghost.ghostOf[v];
      if (g < 0) continue;
      const double distance = (reference[v] - at[g]).squaredNorm();
      if (distance < nearest[g]) {
        nearest[g] = distance;
        ghost.vertexOf[g] = v;
      }
    }
  }

  const WeldedShape& shape_;
  const SimplifyOptions& options_;
  const FractionReport& onProgress_;
  int columns_;
  int faceCount_ = 0;
  std::vector<int> componentOf_;
  std::vector<int> count_;  // remaining faces of each component
  FaceBudget budget_;
  CollapseMesh mesh_;
  Limits limits_ = limits[0];
  std::vector<Vec3> position_;    // [vertex][column]
  std::vector<Quadric> quadric_;  // [vertex][column]
  std::vector<double> error_;     // error of each vertex at its position, summed over all poses
  std::vector<Candidate> rejected_;
  std::vector<int> version_, goneTo_;
  std::priority_queue<Entry> queue_;

  // Scratch memory.
  std::vector<CollapseMesh::Neighbour> ring_, touched_;
  std::vector<Vec3> placed_;
};

}  // namespace

GhostMesh simplify(const WeldedShape& shape, const ShapeTopology& topology, const SimplifyOptions& options,
                   const FractionReport& onProgress) {
  return Simplifier(shape, topology, options, onProgress).run();
}

}  // namespace shapespline
