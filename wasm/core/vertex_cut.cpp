#include "core/vertex_cut.h"

#include <cstddef>
#include <cstdlib>

namespace shapespline {

namespace {

constexpr int kNone = -1;
constexpr int kSource = -2;  // the predecessor of a path's first node
constexpr int kDead = -3;    // the level of a state that is on a path of this round or leads nowhere

// Paths without common nodes through a band. Every node is split in two states, its entrance 2 v and its exit 2 v + 1;
// the paths use an arc from entrance to exit once, which makes them disjoint.
class DisjointPaths {
 public:
  DisjointPaths(const Graph& graph, const std::vector<Side>& side) {
    std::vector<int> local(graph.size(), kNone);
    for (int v = 0; v < graph.size(); ++v) {
      if (side[v] != Side::Separator) continue;
      local[v] = static_cast<int>(node_.size());
      node_.push_back(v);
    }
    const std::size_t count = node_.size();
    atSource_.assign(count, 0);
    atSink_.assign(count, 0);
    for (std::size_t b = 0; b < count; ++b) {
      for (int u : graph.neighbours(node_[b])) {
        if (side[u] == Side::Separator) band_.neighbour.push_back(local[u]);
        else (side[u] == Side::Left ? atSource_ : atSink_)[b] = 1;
      }
      band_.start.push_back(static_cast<int>(band_.neighbour.size()));
    }
    predecessor_.assign(count, kNone);
    level_.resize(2 * count);
    next_.resize(2 * count);
    while (layer())
      for (int b = 0; b < size(); ++b)
        if (atSource_[b] && level_[in(b)] == 0) augment(b);
  }

  // Sides of the band's nodes for the smallest separator nearest to Left: entrance within reach, exit not.
  std::vector<Side> nearestToLeft() const {
    std::vector<Side> result(size());
    for (int b = 0; b < size(); ++b)
      result[b] = !reached(in(b)) ? Side::Right : reached(out(b)) ? Side::Left : Side::Separator;
    return result;
  }

  // The same nearest to Right, from the states that reach the sink.
  std::vector<Side> nearestToRight() const {
    std::vector<int> successor(size(), kNone);
    for (int b = 0; b < size(); ++b)
      if (predecessor_[b] >= 0) successor[predecessor_[b]] = b;
    std::vector<char> reaches(2 * static_cast<std::size_t>(size()), 0);
    std::vector<int> queue;
    const auto visit = [&](int state) {
      if (reaches[state]) return;
      reaches[state] = 1;
      queue.push_back(state);
    };
    for (int b = 0; b < size(); ++b)
      if (atSink_[b]) visit(out(b));
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const int b = queue[head] / 2;
      if (queue[head] == in(b)) {
        for (int u : band_.neighbours(b)) visit(out(u));
        if (used(b)) visit(out(b));
      } else if (!used(b)) {
        visit(in(b));
      } else if (successor[b] != kNone) {
        visit(in(successor[b]));
      }
    }
    std::vector<Side> result(size());
    for (int b = 0; b < size(); ++b)
      result[b] = reaches[in(b)] ? Side::Right : reaches[out(b)] ? Side::Separator : Side::Left;
    return result;
  }

  int nodeAt(int b) const { return node_[b]; }
  int size() const { return static_cast<int>(node_.size()); }

 private:
  static int in(int b) { return 2 * b; }
  static int out(int b) { return 2 * b + 1; }
  bool used(int b) const { return predecessor_[b] != kNone; }
  bool reached(int state) const { return level_[state] != kNone; }

  // The state that an entrance leads to: the node's exit, or back along the path through it. kNone at a path's start.
  int beyond(int b) const {
    if (!used(b)) return out(b);
    return predecessor_[b] == kSource ? kNone : out(predecessor_[b]);
  }

  // Distances of all states from the source; true if the sink is within reach.
  bool layer() {
    queue_.clear();
    for (std::size_t s = 0; s < level_.size(); ++s) level_[s] = kNone, next_[s] = 0;
    const auto visit = [&](int state, int level) {
      if (state == kNone || reached(state)) return;
      level_[state] = level;
      queue_.push_back(state);
    };
    for (int b = 0; b < size(); ++b)
      if (atSource_[b]) visit(in(b), 0);
    bool found = false;
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const int state = queue_[head], b = state / 2, level = level_[state] + 1;
      if (state == in(b)) {
        visit(beyond(b), level);
        continue;
      }
      found = found || atSink_[b];
      for (int u : band_.neighbours(b)) visit(in(u), level);
      if (used(b)) visit(in(b), level);
    }
    return found;
  }

  // The next arc of a state that leads one level on, or kNone. Arcs of an exit: the neighbours, then its own entrance.
  int advance(int state) {
    const int b = state / 2;
    if (state == in(b)) return next_[state]++ == 0 && onNextLevel(state, beyond(b)) ? beyond(b) : kNone;
    for (; next_[state] < band_.degree(b); ++next_[state]) {
      const int to = in(band_.neighbour[band_.start[b] + next_[state]]);
      if (onNextLevel(state, to)) return ++next_[state], to;
    }
    if (next_[state]++ == band_.degree(b) && used(b) && onNextLevel(state, in(b))) return in(b);
    return kNone;
  }

  bool onNextLevel(int from, int to) const { return to != kNone && level_[to] == level_[from] + 1; }

  // Depth-first from an entrance at the source along rising levels; every arc is tried once a round.
  void augment(int start) {
    path_.assign(1, in(start));
    while (!path_.empty()) {
      const int state = path_.back();
      if (state == out(state / 2) && atSink_[state / 2]) return apply();
      const int to = advance(state);
      if (to != kNone) {
        path_.push_back(to);
      } else {
        level_[state] = kDead;
        path_.pop_back();
      }
    }
  }

  // Reroutes the paths. A state lies on one path a round, so that the old predecessors are still those of layer().
  void apply() {
    int from = kSource;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      const int state = path_[i], b = state / 2;
      level_[state] = kDead;
      if (state == in(b)) {
        // Entered from an exit: a new predecessor. Entered from its own exit: its path leaves it.
        const bool leaves = i > 0 && path_[i - 1] == out(b);
        predecessor_[b] = leaves ? kNone : from;
      }
      if (state == out(b)) from = b;
    }
  }

  std::vector<int> node_;
  Graph band_;
  std::vector<char> atSource_, atSink_;
  std::vector<int> predecessor_;  // on the path through the node; kNone if there is none
  std::vector<int> level_, next_, queue_, path_;
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
