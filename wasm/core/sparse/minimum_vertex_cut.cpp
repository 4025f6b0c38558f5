#include "core/sparse/minimum_vertex_cut.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "core/base/sort_indices.h"

namespace shapespline {

namespace {

constexpr int none = -1;
constexpr int source = -2;  // the predecessor of a path's first node

// Vertex-disjoint maximum flow with node splitting: every node of the band has an entrance and an exit, joined by an
// arc of capacity one. A node on a path may be entered again only to return to its predecessor, whose path then takes
// another route. An unused node is therefore always left by its own exit, and a search can move from exit to exit.
class DisjointPaths {
 public:
  DisjointPaths(const Graph& graph, const std::vector<Side>& side) {
    number(graph, side);
    predecessor_.assign(node_.size(), none);
    successor_.assign(node_.size(), none);
    next_.assign(node_.size(), 0);
    findPaths();
  }

  // Sides of the band's nodes for the smallest separator nearest to Left: nodes whose entrance is reachable and whose
  // exit is not.
  std::vector<Side> nearestToLeft() const {
    std::vector<Side> result(node_.size(), Side::Right);
    std::vector<int> queue;
    std::vector<char> reached(node_.size(), 0);  // whether each exit is reachable
    const auto enter = [&](int b) {
      if (result[b] != Side::Right) return;
      result[b] = Side::Separator;
      const int exit = exitBehind(b);
      if (exit < 0 || reached[exit]) return;
      reached[exit] = 1;
      queue.push_back(exit);
    };
    for (int b : atSource_) enter(b);
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const int b = queue[head];
      for (int u : band_.neighbours(b)) enter(u);
      if (used(b)) enter(b);
    }
    for (int b : queue) result[b] = Side::Left;
    return result;
  }

  // Sides for the smallest separator nearest to Right, from the exits that reach the sink.
  std::vector<Side> nearestToRight() const {
    std::vector<Side> result(node_.size(), Side::Left);
    for (int b : queue_) result[b] = Side::Separator;
    for (int b : queue_)
      if (const int entrance = entranceBefore(b); entrance >= 0) result[entrance] = Side::Right;
    return result;
  }

  int nodeAt(int b) const { return node_[b]; }
  int size() const { return static_cast<int>(node_.size()); }

 private:
  bool used(int b) const { return predecessor_[b] != none; }

  // The exit after entering a node: its own, or its predecessor's if it is used. Negative at a path's start.
  int exitBehind(int b) const { return used(b) ? predecessor_[b] : b; }

  // The node to enter to reach an exit. Negative at the end of a path.
  int entranceBefore(int exit) const { return used(exit) ? successor_[exit] : exit; }

  // Numbers the band's nodes by distance from the sink, for locality of the search. Nodes that cannot reach the sink
  // come last.
  void number(const Graph& graph, const std::vector<Side>& side) {
    std::vector<int> local(side.size(), none), band;
    const auto add = [&](int v, int distance) {
      if (side[v] != Side::Separator || local[v] != none) return;
      local[v] = size();
      node_.push_back(v);
      distance_.push_back(distance);
    };
    const auto touches = [&](int v, Side which) {
      const auto neighbours = graph.neighbours(v);
      return std::any_of(neighbours.begin(), neighbours.end(), [&](int u) { return side[u] == which; });
    };
    for (int v = 0; v < graph.size(); ++v) {
      if (side[v] != Side::Separator) continue;
      band.push_back(v);
      if (touches(v, Side::Right)) add(v, 0);
    }
    atSink_ = size();
    for (int b = 0; b < size(); ++b)
      for (int u : graph.neighbours(node_[b])) add(u, distance_[b] + 1);
    queue_.resize(node_.size());
    std::iota(queue_.begin(), queue_.end(), 0);
    for (int v : band) add(v, static_cast<int>(band.size()));
    for (int b = 0; b < size(); ++b) {
      bool first = false;
      for (int u : graph.neighbours(node_[b])) {
        if (local[u] != none) band_.neighbour.push_back(local[u]);
        else first = first || side[u] == Side::Left;
      }
      band_.start.push_back(static_cast<int>(band_.neighbour.size()));
      if (first) atSource_.push_back(b);
    }
  }

  // Searches in rounds (Dinic 1970), nearest starts first. A start that cannot reach the sink never can later: new
  // routes only begin on new paths.
  void findPaths() {
    std::vector<int> starts = atSource_;
    const auto distance = [&](int b) { return exitBehind(b) < 0 ? size() : distance_[exitBehind(b)]; };
    for (bool first = true;; first = false) {
      if (!first) findDistances();
      std::erase_if(starts, [&](int b) { return distance(b) == size(); });
      if (starts.empty()) return;
      sortIndices(starts, [&](int a, int b) { return std::pair(distance(a), a) < std::pair(distance(b), b); });
      std::fill(next_.begin(), next_.end(), 0);
      for (int b : starts)
        if (distance(b) < size()) search(b);
    }
  }

  // Distances of all exits under the current paths; size() if the sink is unreachable. Queues the reachable exits.
  void findDistances() {
    std::fill(distance_.begin(), distance_.end(), size());
    queue_.clear();
    const auto visit = [&](int b, int distance) {
      if (distance_[b] < size()) return;
      distance_[b] = distance;
      queue_.push_back(b);
    };
    for (int b = 0; b < atSink_; ++b) visit(b, 0);
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const int b = entranceBefore(queue_[head]), distance = distance_[queue_[head]] + 1;
      if (b < 0) continue;
      for (int u : band_.neighbours(b)) visit(u, distance);
      if (used(b)) visit(b, distance);
    }
  }

  // Depth-first search from a node at the source along decreasing distances. A dead end gets a larger distance, so
  // longer routes may still use it.
  void search(int start) {
    entered_.assign(1, start);
    path_.assign(1, exitBehind(start));
    while (!path_.empty()) {
      const int from = path_.back();
      if (distance_[from] == 0) return apply();
      const int through = advance(from);
      if (through != none) {
        entered_.push_back(through);
        path_.push_back(exitBehind(through));
      } else {
        raise(from);
        path_.pop_back();
        entered_.pop_back();
      }
    }
  }

  // The next node to enter from an exit, closer to the sink, or none: a neighbour, or the exit's own node.
  int advance(int from) {
    const int wanted = distance_[from] - 1, degree = band_.degree(from);
    const int* neighbour = band_.neighbour.data() + band_.start[from];
    for (int& i = next_[from]; i <= degree; ++i) {
      if (i == degree && !used(from)) continue;
      const int through = i < degree ? neighbour[i] : from, exit = exitBehind(through);
      if (exit >= 0 && distance_[exit] == wanted) return through;
    }
    return none;
  }

  void raise(int from) {
    int least = size();
    const auto consider = [&](int through) {
      const int exit = exitBehind(through);
      if (exit >= 0) least = std::min(least, distance_[exit] + 1);
    };
    for (int u : band_.neighbours(from)) consider(u);
    if (used(from)) consider(from);
    distance_[from] = least;
    next_[from] = 0;
  }

  // Reroutes the paths. No node occurs twice on the route, so the old predecessors are still valid.
  void apply() {
    predecessor_[entered_[0]] = source;
    for (std::size_t i = 1; i < path_.size(); ++i) {
      const int from = path_[i - 1];
      const bool leaves = entered_[i] == from;  // its old path takes another route
      predecessor_[entered_[i]] = leaves ? none : from;
      successor_[from] = leaves ? none : entered_[i];
    }
    successor_[path_.back()] = none;
  }

  std::vector<int> node_;
  Graph band_;
  std::vector<int> atSource_;
  int atSink_ = 0;                            // number of nodes adjacent to the sink, which come first
  std::vector<int> predecessor_, successor_;  // neighbours along the path through the node, or none
  std::vector<int> distance_;                 // lower bounds of the exits' distances from the sink
  std::vector<int> next_;                     // next arc to try at each exit
  std::vector<int> queue_;                    // exits that reach the sink
  std::vector<int> entered_, path_;           // nodes of the current path, and the exits after them
};

long imbalance(const std::vector<Side>& side, const DisjointPaths& paths, const std::vector<Side>& band) {
  long difference = 0;
  for (Side s : side) difference += s == Side::Left ? 1 : s == Side::Right ? -1 : 0;
  for (int b = 0; b < paths.size(); ++b) difference += band[b] == Side::Left ? 1 : band[b] == Side::Right ? -1 : 0;
  return std::labs(difference);
}

}  // namespace

void shrinkSeparator(const Graph& graph, std::vector<Side>& side) {
  const DisjointPaths paths(graph, side);
  const std::vector<Side> left = paths.nearestToLeft(), right = paths.nearestToRight();
  const std::vector<Side>& best = imbalance(side, paths, left) <= imbalance(side, paths, right) ? left : right;
  for (int b = 0; b < paths.size(); ++b) side[paths.nodeAt(b)] = best[b];
}

}  // namespace shapespline
