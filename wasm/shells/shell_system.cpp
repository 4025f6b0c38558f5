#include "shells/shell_system.h"

#include <algorithm>
#include <utility>

#include "core/sparse/ordering.h"

namespace shapespline {

namespace {

// damping of vertices without edges, as a share of the mean diagonal
constexpr double minDamping = 1e-8;

// The three unknowns of a vertex are adjacent.
std::vector<int> orderInBlocks(const Graph& vertices) {
  std::vector<int> order;
  for (const int v : fillReducingOrder(vertices, {}))
    for (int c = 0; c < 3; ++c) order.push_back(3 * v + c);
  return order;
}

}  // namespace

Result<ShellSystem> ShellSystem::create(const ShellMetric& metric) {
  ShellSystem system(metric);
  system.findPattern();
  Graph vertices;
  std::vector<std::vector<int>> neighbours(metric.vertexCount());
  for (const Block& b : system.blocks_)
    if (b.lower != b.higher) {
      neighbours[b.lower].push_back(b.higher);
      neighbours[b.higher].push_back(b.lower);
    }
  for (std::vector<int>& list : neighbours) {
    std::sort(list.begin(), list.end());
    vertices.neighbour.insert(vertices.neighbour.end(), list.begin(), list.end());
    vertices.start.push_back(static_cast<int>(vertices.neighbour.size()));
  }
  if (Status status = system.solver_.analyse(system.matrix_, {}, Precision::Double, {}, orderInBlocks(vertices));
      !status)
    return status.error();
  system.work_.assign(4 * static_cast<std::size_t>(system.solver_.paddedSize()), 0);
  return system;
}

void ShellSystem::findPattern() {
  const int vertices = metric_->vertexCount();
  std::vector<std::vector<int>> higher(vertices);
  for (int v = 0; v < vertices; ++v) higher[v].push_back(v);
  for (const ShellEdge& e : metric_->edges()) {
    const std::array<int, 4> corners = {e.from, e.to, e.left, e.right};
    const int count = e.left < 0 ? 2 : 4;
    for (int a = 0; a < count; ++a)
      for (int b = 0; b < a; ++b) higher[std::min(corners[a], corners[b])].push_back(std::max(corners[a], corners[b]));
  }
  matrix_.size = 3 * vertices;
  matrix_.columnStart = {0};
  rowStart_ = {0};
  for (int v = 0; v < vertices; ++v) {
    std::sort(higher[v].begin(), higher[v].end());
    higher[v].erase(std::unique(higher[v].begin(), higher[v].end()), higher[v].end());
    const std::size_t first = blocks_.size();
    for (const int h : higher[v]) blocks_.push_back({v, h, {}});
    for (int c = 0; c < 3; ++c) {
      for (std::size_t b = first; b < blocks_.size(); ++b) {
        blocks_[b].start[c] = static_cast<int>(matrix_.row.size());
        for (int r = b == first ? c : 0; r < 3; ++r) matrix_.row.push_back(3 * blocks_[b].higher + r);
      }
      matrix_.columnStart.push_back(static_cast<int>(matrix_.row.size()));
    }
    rowStart_.push_back(static_cast<int>(blocks_.size()));
  }
  matrix_.value.assign(matrix_.row.size(), 0);
  damped_ = matrix_;
  for (int m = 0; m < metric_->measureCount(); ++m) {
    const ShellEdge& e = metric_->edges()[m < metric_->edgeCount() ? m : m - metric_->edgeCount()];
    const std::array<int, 4> corners = {e.from, e.to, e.left, e.right};
    std::array<int, 10> list{};
    int count = 0;
    for (int a = 0; a < (m < metric_->edgeCount() ? 2 : 4); ++a)
      for (int b = 0; b <= a; ++b) list[count++] = blockOf(corners[a], corners[b]);
    blocksOf_.push_back(list);
  }
}

int ShellSystem::blockOf(int a, int b) const {
  const auto [lower, higher] = std::minmax(a, b);
  const auto end = blocks_.begin() + rowStart_[lower + 1];
  const auto found = std::lower_bound(blocks_.begin() + rowStart_[lower], end, higher,
                                      [](const Block& block, int vertex) { return block.higher < vertex; });
  return static_cast<int>(found - blocks_.begin());
}

// part: rows of the higher vertex, columns of the lower.
void ShellSystem::add(const Block& block, const Mat3& part) {
  const bool diagonal = block.lower == block.higher;
  for (int c = 0; c < 3; ++c)
    for (int r = diagonal ? c : 0; r < 3; ++r) matrix_.value[block.start[c] + (diagonal ? r - c : r)] += part(r, c);
}

void ShellSystem::fill(const Positions& positions) {
  std::fill(matrix_.value.begin(), matrix_.value.end(), 0);
  for (int m = 0; m < metric_->measureCount(); ++m) {
    const ShellMetric::Row row = metric_->rowOf(m, positions);
    const double weight = metric_->weights()[m];
    int next = 0;
    for (int a = 0; a < row.count; ++a)
      for (int b = 0; b <= a; ++b) {
        const Block& block = blocks_[blocksOf_[m][next++]];
        const bool aIsHigher = row.vertex[a] >= row.vertex[b];
        add(block, weight * row.gradient[aIsHigher ? a : b] * row.gradient[aIsHigher ? b : a].transpose());
      }
  }
}

bool ShellSystem::factor(double damping) {
  damped_.value = matrix_.value;
  const int vertices = metric_->vertexCount();
  const auto diagonal = [&](int v, int c) { return blocks_[rowStart_[v]].start[c]; };
  std::vector<double> mean(vertices);
  double all = 0;
  for (int v = 0; v < vertices; ++v) {
    for (int c = 0; c < 3; ++c) mean[v] += matrix_.value[diagonal(v, c)] / 3;
    all += mean[v] / vertices;
  }
  for (int v = 0; v < vertices; ++v)
    for (int c = 0; c < 3; ++c) damped_.value[diagonal(v, c)] += damping * mean[v] + minDamping * all;
  ++factors_;
  return solver_.factorise(damped_).ok();
}

Positions ShellSystem::solve(const Positions& right) {
  const std::span<const int> position = solver_.eliminationPosition();
  std::fill(work_.begin(), work_.end(), 0);
  for (std::size_t v = 0; v < right.size(); ++v)
    for (int c = 0; c < 3; ++c) work_[4 * static_cast<std::size_t>(position[3 * v + c])] = right[v][c];
  solver_.solve(work_.data());
  Positions solution(right.size());
  for (std::size_t v = 0; v < right.size(); ++v)
    for (int c = 0; c < 3; ++c) solution[v][c] = work_[4 * static_cast<std::size_t>(position[3 * v + c])];
  return solution;
}

Positions ShellSystem::transposed(const Positions& positions, const ShellMeasures& difference) const {
  Positions result(positions.size(), Vec3::Zero());
  for (int m = 0; m < metric_->measureCount(); ++m) {
    const ShellMetric::Row row = metric_->rowOf(m, positions);
    const double force = metric_->weights()[m] * difference[m];
    for (int a = 0; a < row.count; ++a) result[row.vertex[a]] += force * row.gradient[a];
  }
  return result;
}

void addScaled(Positions& to, double factor, const Positions& from) {
  for (std::size_t v = 0; v < to.size(); ++v) to[v] += factor * from[v];
}

double dot(const Positions& a, const Positions& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += a[v].dot(b[v]);
  return sum;
}

double largestNorm(const Positions& p) {
  double largest = 0;
  for (const Vec3& v : p) largest = std::max(largest, v.norm());
  return largest;
}

}  // namespace shapespline
