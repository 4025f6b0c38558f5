#include "core/vertex_cover.h"

#include <cstddef>

namespace shapespline {

namespace {

class Matching {
 public:
  explicit Matching(const BipartiteGraph& graph)
      : graph_(graph), ofLeft_(graph.leftSize(), -1), ofRight_(graph.rightSize, -1), level_(graph.leftSize()),
        next_(graph.leftSize()) {
    while (layer())
      for (int v = 0; v < graph_.leftSize(); ++v)
        if (ofLeft_[v] == -1) augment(v);
  }

  // König: of the left the nodes out of reach of unmatched ones by alternating paths, of the right those in reach.
  // After the last layer() level_ tells which left nodes are in reach.
  VertexCover cover() const {
    VertexCover result;
    std::vector<char> reached(graph_.rightSize, 0);
    for (int v = 0; v < graph_.leftSize(); ++v) {
      if (level_[v] == -1) result.left.push_back(v);
      else
        for (int i = graph_.start[v]; i < graph_.start[v + 1]; ++i) reached[graph_.neighbour[i]] = 1;
    }
    for (int u = 0; u < graph_.rightSize; ++u)
      if (reached[u]) result.right.push_back(u);
    return result;
  }

 private:
  // Distances of the left nodes from the unmatched ones; true if an augmenting path exists.
  bool layer() {
    queue_.clear();
    for (int v = 0; v < graph_.leftSize(); ++v) {
      next_[v] = graph_.start[v];
      level_[v] = ofLeft_[v] == -1 ? 0 : -1;
      if (level_[v] == 0) queue_.push_back(v);
    }
    bool found = false;
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const int v = queue_[head];
      for (int i = graph_.start[v]; i < graph_.start[v + 1]; ++i) {
        const int w = ofRight_[graph_.neighbour[i]];
        if (w == -1) {
          found = true;
        } else if (level_[w] == -1) {
          level_[w] = level_[v] + 1;
          queue_.push_back(w);
        }
      }
    }
    return found;
  }

  // Depth-first along rising levels from an unmatched left node; every edge is looked at once a phase.
  void augment(int root) {
    path_.assign(1, root);
    while (!path_.empty()) {
      const int v = path_.back();
      if (next_[v] == graph_.start[v + 1]) {
        path_.pop_back();
        if (!path_.empty()) ++next_[path_.back()];
        continue;
      }
      const int w = ofRight_[graph_.neighbour[next_[v]]];
      if (w == -1) {
        for (int x : path_) match(x, graph_.neighbour[next_[x]]);
        return;
      }
      if (level_[w] == level_[v] + 1) path_.push_back(w);
      else ++next_[v];
    }
  }

  void match(int v, int u) { ofLeft_[v] = u, ofRight_[u] = v; }

  const BipartiteGraph& graph_;
  std::vector<int> ofLeft_, ofRight_, level_, next_, queue_, path_;
};

}  // namespace

VertexCover minimumVertexCover(const BipartiteGraph& graph) { return Matching(graph).cover(); }

}  // namespace shapespline
