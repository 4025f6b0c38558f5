#include "core/multifrontal.h"

#include <algorithm>

#include "core/dense_front.h"
#include "core/out_of_line.h"
#include "core/simd.h"

namespace shapespline {

namespace {

// Strips eliminated between two looks at the budget.
constexpr int kStripsAtOnce = 32;

Pivots pivotsOf(const SymbolicFactor& symbolic, int s) { return Pivots(symbolic.columns(s)); }
int updateStrips(const SymbolicFactor& symbolic, int s) { return stripsFor(symbolic.rows(s)); }

// The largest size that the stack will have, in doubles.
std::size_t stackPeak(const SymbolicFactor& symbolic) {
  std::vector<std::size_t> childUpdates(symbolic.supernodes(), 0);
  std::size_t top = 0, peak = 0;
  for (int s = 0; s < symbolic.supernodes(); ++s) {
    const int update = updateStrips(symbolic, s);
    peak = std::max(peak, top + stripOffset(pivotsOf(symbolic, s).strips + update));
    top = top - childUpdates[s] + stripOffset(update);
    if (symbolic.parent[s] != -1) childUpdates[symbolic.parent[s]] += stripOffset(update);
  }
  return peak;
}

// What memset and memcpy do for whole strips: WebAssembly's C library has them a word at a time or asks JavaScript to do it.
// stepBack() keeps compilers from calling them all the same.
void clear(double* begin, std::size_t n) {
  for (double* p = begin + n; p != begin;) {
    p = stepBack(p, 4);
    Double4::zero().store(p);
  }
}
void copy(const double* from, std::size_t n, double* to) {
  to += n;
  for (const double* p = from + n; p != from;) {
    p = stepBack(p, 4), to = stepBack(to, 4);
    Double4::load(p).store(to);
  }
}

// Adds a strip of an update matrix, `rows` rows from row `first` on, to its parent's front: entry (r, c) at
// target[r - first][column[c]].
void addStrip(const double* strip, int first, int rows, double* const* target, const int* column) {
  if (rows == 4 && target[1] == target[0] + 1 && target[3] == target[2] + 1) {  // two and two side by side
    double *a = target[0], *c = target[2];
    for (int k = 0; k < first; ++k, strip += 4) {
      const int to = column[k];
      (Double2::load(a + to) + Double2::load(strip)).store(a + to);
      (Double2::load(c + to) + Double2::load(strip + 2)).store(c + to);
    }
  } else if (rows == 4) {
    double *a = target[0], *b = target[1], *c = target[2], *d = target[3];
    for (int k = 0; k < first; ++k, strip += 4) {
      const int to = column[k];
      a[to] += strip[0], b[to] += strip[1], c[to] += strip[2], d[to] += strip[3];
    }
  } else {
    for (int k = 0; k < first; ++k, strip += 4)
      for (int r = 0; r < rows; ++r) target[r][column[k]] += strip[r];
  }
  for (int k = 0; k < rows; ++k, strip += 4)
    for (int r = k; r < rows; ++r) target[r][column[first + k]] += strip[r];
}

}  // namespace

EntryMap mapEntries(const SymmetricMatrix& matrix, const std::vector<int>& position) {
  EntryMap map;
  map.start.assign(static_cast<std::size_t>(matrix.size) + 1, 0);
  const auto forEachEntry = [&](auto visit) {
    for (int column = 0; column < matrix.size; ++column)
      for (int i = matrix.columnStart[column]; i < matrix.columnStart[column + 1]; ++i) {
        const int p = position[column], q = position[matrix.row[i]];
        visit(std::min(p, q), std::max(p, q), i);
      }
  };
  forEachEntry([&](int p, int, int) { ++map.start[p + 1]; });
  for (int p = 0; p < matrix.size; ++p) map.start[p + 1] += map.start[p];
  map.row.resize(matrix.row.size());
  map.source.resize(matrix.row.size());
  std::vector<int> next(map.start.begin(), map.start.end() - 1);
  forEachEntry([&](int p, int q, int i) {
    map.row[next[p]] = q;
    map.source[next[p]++] = i;
  });
  return map;
}

Multifrontal::Multifrontal(const SymbolicFactor& symbolic, const EntryMap& map, const std::vector<double>& values)
    : symbolic_(symbolic), map_(map), values_(values), stackSize_(stackPeak(symbolic)),
      stack_(std::make_unique_for_overwrite<double[]>(stackSize_)) {
  const int count = symbolic.supernodes();
  firstChild_.assign(count, -1);
  sibling_.assign(count, -1);
  updateBase_.assign(count, 0);
  local_.assign(symbolic.size(), -1);
  for (int s = 0; s < count; ++s) {
    if (symbolic.parent[s] == -1) continue;
    sibling_[s] = firstChild_[symbolic.parent[s]];
    firstChild_[symbolic.parent[s]] = s;
  }
}

void Multifrontal::assembleFront() {
  const int s = supernode_, first = symbolic_.first[s], columns = symbolic_.columns(s), rows = symbolic_.rows(s);
  const Pivots pivots = pivotsOf(symbolic_, s);
  const int pivotRows = 4 * pivots.strips;
  const int* row = symbolic_.rowsOf(s);
  frontBase_ = stackTop_;
  double* front = stack_.get() + frontBase_;
  outOfLine(clear)(front, stripOffset(pivots.strips + updateStrips(symbolic_, s)));

  for (int c = 0; c < columns; ++c) local_[first + c] = pivots.padding + c;
  for (int r = 0; r < rows; ++r) local_[row[r]] = pivotRows + r;
  const auto at = [&](int r, int c) -> double& { return front[stripOffset(r / 4) + 4 * static_cast<std::size_t>(c) + r % 4]; };
  reference_.assign(pivotRows, 1.0);
  inverse_.resize(4 * static_cast<std::size_t>(pivotRows));
  for (int c = 0; c < pivots.padding; ++c) at(c, c) = 1.0;
  for (int c = 0, to = pivots.padding; c < columns; ++c, ++to) {
    for (int i = map_.start[first + c]; i < map_.start[first + c + 1]; ++i) at(local_[map_.row[i]], to) += values_[map_.source[i]];
    reference_[to] = at(to, to);
  }
  for (int child = firstChild_[s]; child != -1; child = sibling_[child]) addChild(child, front);
}

void Multifrontal::addChild(int child, double* front) {
  const int rows = symbolic_.rows(child);
  const int* row = symbolic_.rowsOf(child);
  target_.resize(4 * static_cast<std::size_t>(updateStrips(symbolic_, child)));
  column_.resize(rows);
  for (int r = 0; r < rows; ++r) {
    const int to = local_[row[r]];
    target_[r] = front + stripOffset(to / 4) + to % 4;
    column_[r] = 4 * to;
  }
  const auto add = outOfLine(addStrip);
  const double* update = stack_.get() + updateBase_[child];
  for (int r = 0; r < rows; r += 4) add(update + stripOffset(r / 4), r, std::min(4, rows - r), target_.data() + r, column_.data());
}

bool Multifrontal::eliminate(double& flopBudget) {
  if (nextStrip_ == -1) {
    assembleFront();
    nextStrip_ = 0;
  }
  const Pivots pivots = pivotsOf(symbolic_, supernode_);
  const int strips = pivots.strips + updateStrips(symbolic_, supernode_);
  double* front = stack_.get() + frontBase_;
  while (nextStrip_ < strips && flopBudget > 0.0) {
    const int end = std::min(strips, nextStrip_ + kStripsAtOnce);
    PivotReport report;
    eliminateStrips(front, pivots, nextStrip_, end, reference_.data(), inverse_.data(), report);
    regularised_ += report.regularised;
    if (report.failed != -1 && failed_ == -1) failed_ = symbolic_.first[supernode_] + report.failed - pivots.padding;
    const double flops = eliminationFlops(pivots, nextStrip_, end);
    flopBudget -= flops;
    flopsDone_ += flops;
    nextStrip_ = end;
  }
  return nextStrip_ == strips;
}

void Multifrontal::finishFront() {
  const int s = supernode_, pivots = pivotsOf(symbolic_, s).strips, update = updateStrips(symbolic_, s);
  // The children's update matrices lie directly below the front, the first pushed one lowest.
  std::size_t base = frontBase_;
  for (int child = firstChild_[s]; child != -1; child = sibling_[child]) base = updateBase_[child];
  double* target = stack_.get() + base;
  const double* front = stack_.get() + frontBase_;
  const auto move = outOfLine(copy);
  for (int i = 0; i < update; ++i) {
    const double* strip = front + stripOffset(pivots + i) + 16 * static_cast<std::size_t>(pivots);
    move(strip, 16 * static_cast<std::size_t>(i + 1), target + stripOffset(i));
  }
  updateBase_[s] = base;
  stackTop_ = base + stripOffset(update);
  nextStrip_ = -1;
  ++supernode_;
}

double factorisationFlops(const SymbolicFactor& symbolic) {
  double flops = 0.0;
  for (int s = 0; s < symbolic.supernodes(); ++s) {
    const Pivots pivots = pivotsOf(symbolic, s);
    flops += eliminationFlops(pivots, 0, pivots.strips + updateStrips(symbolic, s));
  }
  return flops;
}

}  // namespace shapespline
