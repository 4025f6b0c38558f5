// The per-face part of the coordinates, laid out for the frame kernel: it is what a frame streams through memory.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/permutation.h"
#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/spline/pose_weights.h"

namespace shapespline {

/// Numbers of a face and column: log(G_p(f)^T R_f) (3), then S_f or log S_f as xx, xy, yy in the reference tangent
/// frame.
inline constexpr int numbersPerFace = 6;

/// Faces side by side in one vector register.
inline constexpr int faceLanes = 4;

/// A stored column, by its index among them, and its weight.
template <class Real>
struct WeightedColumn {
  int column;
  Real weight;
};

/// The key that a frame beyond the keys goes on from, and where the columns have the keys.
struct EndKey {
  int column;      ///< of the end key among the stored columns, or -1 where its faces rest
  int storedKeys;  ///< the first stored columns, which are keys
  bool anyAtRest;  ///< whether faces rest in one of the keys
};

/// What a frame takes of the columns: those that are stored and whose weight can be seen, and what those at rest add to
/// the diagonal of S_f. Beyond the keys the weights are those of the change from the end key on.
template <class Real>
struct ColumnWeights {
  std::vector<WeightedColumn<Real>> stored;
  Real atRest = 0;
  std::optional<EndKey> end;
};

/// Six numbers for each face and column, in blocks of four faces: [block][column][number][lane], so a frame reads them
/// once, forwards. The last block is padded. Faces lie in their own order until they are reordered. A column in which
/// every face rests, as in the reference pose, is not stored.
template <class Real>
class FaceCoordinates {
 public:
  FaceCoordinates() = default;

  /// All faces at rest: no rotation, and a diagonal of `rest`, 1 for S_f = I and 0 for its logarithm.
  FaceCoordinates(int faces, int columns, Real rest)
      : blocks_((faces + faceLanes - 1) / faceLanes), rest_(rest), storedAs_(columns, -1) {}

  /// Makes room for what set() writes, in every column.
  void store() {
    stored_ = columns();
    for (int c = 0; c < stored_; ++c) storedAs_[c] = c;
    data_.assign(static_cast<std::size_t>(blocks_) * blockSize(), Real(0));
    if (rest_ == 0) return;
    for (std::size_t at = 0; at < data_.size(); at += numbersPerFace * faceLanes)
      for (int k = 0; k < numbersPerFace; ++k) std::fill_n(&data_[at + k * faceLanes], faceLanes, restOf(k));
  }

  int columns() const { return static_cast<int>(storedAs_.size()); }
  /// Where a face lies in the blocks: block slot / faceLanes, lane slot % faceLanes.
  int slot(int face) const { return face < static_cast<int>(slot_.size()) ? slot_[face] : face; }
  void set(int face, int column, int number, Real value) {
    data_[index(slot(face), storedAs_[column], number)] = value;
  }
  Real at(int face, int column, int number) const {
    return storedAs_[column] < 0 ? restOf(number) : data_[index(slot(face), storedAs_[column], number)];
  }
  /// The stored columns of four faces.
  const Real* block(int block) const { return data_.data() + static_cast<std::size_t>(block) * blockSize(); }

  ColumnWeights<Real> weights(const PoseWeights& poses) const {
    ColumnWeights<Real> result;
    double atRest = 0;
    for (int c = 0; c < columns(); ++c) {
      const double weight = poses.column[c] - (c == poses.beyond ? 1 : 0);
      if (storedAs_[c] < 0) atRest += weight;
      else if (std::abs(weight) >= leastWeight<Real>)
        result.stored.push_back({storedAs_[c], static_cast<Real>(weight)});
    }
    result.atRest = static_cast<Real>(atRest) * rest_;
    if (poses.beyond < 0) return result;
    EndKey end{storedAs_[poses.beyond], 0, false};
    for (int c = 0; c < poses.keys; ++c) {
      if (storedAs_[c] < 0) end.anyAtRest = true;
      else ++end.storedKeys;
    }
    result.end = end;
    return result;
  }

  Vec3 rotation(int face, int column) const {
    return {static_cast<double>(at(face, column, 0)), static_cast<double>(at(face, column, 1)),
            static_cast<double>(at(face, column, 2))};
  }
  void setRotation(int face, int column, const Vec3& v) {
    for (int k = 0; k < 3; ++k) set(face, column, k, static_cast<Real>(v[k]));
  }

  /// Stops storing a column in which every face rests, to the last bit.
  void dropIfAtRest(int column) {
    const int dropped = storedAs_[column];
    if (dropped < 0) return;
    const std::size_t size = blockSize(), part = numbersPerFace * faceLanes;
    for (std::size_t b = 0; b < static_cast<std::size_t>(blocks_); ++b)
      for (std::size_t i = 0; i < part; ++i)
        if (data_[b * size + dropped * part + i] != restOf(static_cast<int>(i / faceLanes))) return;
    auto to = data_.begin();
    for (auto from = data_.begin(); from != data_.end(); from += size) {
      const auto gap = from + dropped * part;
      to = std::copy(from, gap, to);
      to = std::copy(gap + part, from + size, to);
    }
    data_.erase(to, data_.end());
    data_.shrink_to_fit();
    storedAs_[column] = -1;
    for (int& stored : storedAs_)
      if (stored > dropped) --stored;
    --stored_;
  }

  /// Moves the faces within the blocks, column by column to hold a second copy of one only: order[i] is the face that
  /// comes to slot i. Once only.
  void reorder(const std::vector<int>& order, const FractionReport& onProgress = {}) {
    assert(slot_.empty() && isPermutation(order));
    slot_.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) slot_[order[i]] = static_cast<int>(i);
    std::vector<Real> moved(order.size() * numbersPerFace);
    for (int c = 0; c < stored_; ++c) {
      const double from = static_cast<double>(c) / stored_, middle = from + 0.7 / stored_, to = from + 1.0 / stored_;
      inBlocks(partOf(onProgress, from, middle), order.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          for (int k = 0; k < numbersPerFace; ++k) moved[numbersPerFace * i + k] = data_[index(order[i], c, k)];
      });
      inBlocks(partOf(onProgress, middle, to), order.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          for (int k = 0; k < numbersPerFace; ++k)
            data_[index(static_cast<int>(i), c, k)] = moved[numbersPerFace * i + k];
      });
    }
  }

 private:
  Real restOf(int number) const { return number == 3 || number == 5 ? rest_ : Real(0); }
  std::size_t blockSize() const { return static_cast<std::size_t>(stored_) * numbersPerFace * faceLanes; }
  std::size_t index(int slot, int column, int number) const {
    return static_cast<std::size_t>(slot / faceLanes) * blockSize() +
           (static_cast<std::size_t>(column) * numbersPerFace + number) * faceLanes + slot % faceLanes;
  }

  int blocks_ = 0, stored_ = 0;
  Real rest_ = 0;
  std::vector<int> storedAs_;  // of each column among the stored ones, or -1
  std::vector<int> slot_;      // of each face; empty while they lie in their own order
  std::vector<Real> data_;
};

}  // namespace shapespline
