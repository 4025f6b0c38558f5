#include "core/separator.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>

#include <Eigen/Eigenvalues>

#include "core/vertex_cover.h"

namespace shapespline {

namespace {

// A side may hold 12 % more than half of the nodes: less balance than this costs more fill than a shorter
// separator saves.
constexpr double kSlack = 0.12;

// The principal axes, longest first.
std::array<Vec3, 3> principalAxes(std::span<const Vec3> points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  Mat3 covariance = Mat3::Zero();
  for (const Vec3& p : points) covariance += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(covariance);
  return {solver.eigenvectors().col(2), solver.eigenvectors().col(1), solver.eigenvectors().col(0)};
}

// Left and Right by the median along a direction, ties by number.
std::vector<Side> medianCut(std::span<const Vec3> coordinates, const Vec3& direction) {
  const std::size_t size = coordinates.size();
  std::vector<double> value(size);
  for (std::size_t v = 0; v < size; ++v) value[v] = direction.dot(coordinates[v]);
  std::vector<double> sorted = value;
  const std::size_t half = size / 2;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(half), sorted.end());
  const double median = sorted[half];
  std::size_t tiesLeft = half;
  for (double x : value) tiesLeft -= x < median;
  std::vector<Side> side(size);
  for (std::size_t v = 0; v < size; ++v) {
    const bool left = value[v] < median || (value[v] == median && tiesLeft > 0);
    if (value[v] == median && tiesLeft > 0) --tiesLeft;
    side[v] = left ? Side::Left : Side::Right;
  }
  return side;
}

std::size_t cutEdges(const Graph& graph, const std::vector<Side>& side) {
  std::size_t cut = 0;
  for (int v = 0; v < graph.size(); ++v)
    if (side[v] == Side::Left)
      for (int u : graph.neighbours(v)) cut += side[u] == Side::Right;
  return cut;
}

// The smallest set of nodes that touches every edge between Left and Right becomes the separator.
void coverCut(const Graph& graph, std::vector<Side>& side) {
  std::vector<int> node[2];
  std::vector<int> local(graph.size(), -1);
  BipartiteGraph cut;
  const auto index = [&](int v, int which) {
    if (local[v] == -1) {
      local[v] = static_cast<int>(node[which].size());
      node[which].push_back(v);
    }
    return local[v];
  };
  cut.start.push_back(0);
  for (int v = 0; v < graph.size(); ++v) {
    if (side[v] != Side::Left) continue;
    bool touches = false;
    for (int u : graph.neighbours(v)) {
      if (side[u] != Side::Right) continue;
      touches = true;
      cut.neighbour.push_back(index(u, 1));
    }
    if (!touches) continue;
    index(v, 0);
    cut.start.push_back(static_cast<int>(cut.neighbour.size()));
  }
  cut.rightSize = static_cast<int>(node[1].size());
  const VertexCover cover = minimumVertexCover(cut);
  for (int v : cover.left) side[node[0][v]] = Side::Separator;
  for (int v : cover.right) side[node[1][v]] = Side::Separator;
}

// State of one Fiduccia-Mattheyses refinement of a separator.
class Refinement {
 public:
  Refinement(const Graph& graph, std::vector<Side>& side, double slack)
      : graph_(graph), side_(side), pulled_(2 * side.size(), 0), locked_(side.size(), 0) {
    for (Side s : side) ++count_[static_cast<int>(s)];
    const double limit = (0.5 + slack) * static_cast<double>(side.size());
    limit_ = std::max<long>({static_cast<long>(limit), count_[0], count_[1]});
  }

  // One pass; true if it found something better.
  bool pass() {
    for (int v = 0; v < graph_.size(); ++v)
      if (side_[v] == Side::Separator) enterSeparator(v);
    const Score before = score();
    Score best = before;
    std::size_t bestLength = 0;
    for (int sinceBest = 0; sinceBest < kPatience;) {
      const int to = chooseSide();
      if (to == -1) break;
      move(takeBest(to), to);
      if (score() < best) {
        best = score();
        bestLength = log_.size();
        sinceBest = 0;
      } else {
        ++sinceBest;
      }
    }
    rollBack(bestLength);
    clear();
    return best < before;
  }

 private:
  static constexpr int kPatience = 100;   // moves without improvement
  static constexpr int kBuckets = 10;     // by nodes pulled into the separator, the last takes all beyond
  struct Change {
    int node;
    Side from;
  };
  struct Score {
    long separator, imbalance;
    bool operator<(const Score& other) const {
      return separator != other.separator ? separator < other.separator : imbalance < other.imbalance;
    }
  };

  Score score() const { return {count_[2], std::labs(count_[0] - count_[1])}; }

  // Nodes of the other side that v would pull into the separator by moving to side `to`.
  int& pulled(int v, int to) { return pulled_[2 * static_cast<std::size_t>(v) + to]; }

  void push(int v, int to) {
    const int bucket = std::min(pulled(v, to), kBuckets - 1);
    bucket_[to][bucket].push_back(v);
  }

  void enterSeparator(int v) {
    pulled(v, 0) = pulled(v, 1) = 0;
    for (int u : graph_.neighbours(v)) {
      if (side_[u] == Side::Right) ++pulled(v, 0);
      if (side_[u] == Side::Left) ++pulled(v, 1);
    }
    if (locked_[v]) return;
    push(v, 0), push(v, 1);
  }

  void setSide(int v, Side to) {
    log_.push_back({v, side_[v]});
    --count_[static_cast<int>(side_[v])];
    ++count_[static_cast<int>(to)];
    side_[v] = to;
  }

  // The top valid candidate's bucket for moves to a side, or kBuckets.
  int topBucket(int to) {
    for (int b = 0; b < kBuckets; ++b) {
      std::vector<int>& bucket = bucket_[to][b];
      while (!bucket.empty()) {
        const int v = bucket.back();
        if (side_[v] == Side::Separator && !locked_[v] && std::min(pulled(v, to), kBuckets - 1) == b) return b;
        bucket.pop_back();
      }
    }
    return kBuckets;
  }

  // The side with the better move that keeps the balance, or -1.
  int chooseSide() {
    int top[2] = {topBucket(0), topBucket(1)};
    for (int to = 0; to < 2; ++to)
      if (count_[to] >= limit_) top[to] = kBuckets;
    if (top[0] == kBuckets && top[1] == kBuckets) return -1;
    if (top[0] != top[1]) return top[0] < top[1] ? 0 : 1;
    return count_[0] <= count_[1] ? 0 : 1;
  }

  int takeBest(int to) {
    std::vector<int>& bucket = bucket_[to][topBucket(to)];
    const int v = bucket.back();
    bucket.pop_back();
    return v;
  }

  void move(int v, int to) {
    const Side mine = static_cast<Side>(to), other = static_cast<Side>(1 - to);
    locked_[v] = 1;
    lockedNodes_.push_back(v);
    setSide(v, mine);
    for (int u : graph_.neighbours(v)) {
      if (side_[u] == Side::Separator) {
        ++pulled(u, 1 - to);
        if (!locked_[u]) push(u, 1 - to);
      } else if (side_[u] == other) {
        setSide(u, Side::Separator);
        for (int w : graph_.neighbours(u)) {
          if (side_[w] != Side::Separator || w == u) continue;
          --pulled(w, to);
          if (!locked_[w]) push(w, to);
        }
        enterSeparator(u);
      }
    }
  }

  void rollBack(std::size_t length) {
    while (log_.size() > length) {
      const Change change = log_.back();
      log_.pop_back();
      --count_[static_cast<int>(side_[change.node])];
      ++count_[static_cast<int>(change.from)];
      side_[change.node] = change.from;
    }
    log_.clear();
  }

  void clear() {
    for (int v : lockedNodes_) locked_[v] = 0;
    lockedNodes_.clear();
    for (auto& side : bucket_)
      for (auto& bucket : side) bucket.clear();
  }

  const Graph& graph_;
  std::vector<Side>& side_;
  std::vector<int> pulled_;
  std::vector<char> locked_;
  std::vector<int> lockedNodes_;
  std::vector<Change> log_;
  std::array<std::array<std::vector<int>, kBuckets>, 2> bucket_;
  std::array<long, 3> count_ = {0, 0, 0};
  long limit_ = 0;
};

}  // namespace

void refineSeparator(const Graph& graph, std::vector<Side>& side, double slack) {
  constexpr int kPasses = 6;
  Refinement refinement(graph, side, slack);
  for (int i = 0; i < kPasses && refinement.pass(); ++i) {
  }
}

std::vector<Side> findSeparator(const Graph& graph, std::span<const Vec3> coordinates) {
  std::vector<Side> best;
  std::size_t bestCut = 0;
  for (const Vec3& axis : principalAxes(coordinates)) {
    std::vector<Side> side = medianCut(coordinates, axis);
    const std::size_t cut = cutEdges(graph, side);
    if (best.empty() || cut < bestCut) {
      best = std::move(side);
      bestCut = cut;
    }
  }
  coverCut(graph, best);
  refineSeparator(graph, best, kSlack);
  return best;
}

}  // namespace shapespline
