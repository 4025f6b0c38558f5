// Per-face coordinates in the layout of the frame kernel, which reads all of them for every frame.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/base/permutation.h"
#include "core/base/progress.h"
#include "core/base/types.h"
#include "core/spline/pose_weights.h"

namespace shapespline {

/// Numbers per face and column: log(G_p(f)^T R_f) (3), then S_f or log S_f as xx, xy, yy in the reference tangent
/// frame.
inline constexpr int numbersPerFace = 6;

/// Number of faces per vector register.
inline constexpr int faceLanes = 4;

/// The end key for a frame beyond the keys, and the columns that store keys.
struct EndKey {
  int column;      ///< stored column of the end key, or -1 if its faces rest
  int storedKeys;  ///< number of leading stored columns that are keys
  bool anyAtRest;  ///< whether faces rest in any key
};

/// A frame's weights: the stored columns with significant weights, and the contribution of columns at rest to the
/// diagonal of S_f. Beyond the keys, the weights describe the change from the end key.
template <class Real>
struct ColumnWeights {
  std::vector<int> stored;
  /// For each part of a curve: a weight for each column in `stored`, then the contribution at rest, each faceLanes
  /// times.
  std::vector<Real> lanes;
  std::span<const int> partOf;  ///< part of each local frame; empty with one part
  std::optional<EndKey> end;

  const Real* ofPart(int part) const { return &lanes[part * (stored.size() + 1) * faceLanes]; }
};

/// Six numbers for each face and column in blocks of four faces: [block][column][number][lane]. A frame reads them
/// once, in order. The last block is padded. Faces are in mesh order until reorder(). A column in which every face
/// rests, such as the reference pose, is not stored.
template <class Real>
class FaceCoordinates {
 public:
  FaceCoordinates() = default;

  /// Initialises all faces at rest: no rotation, and a diagonal of `rest`: 1 for S_f = I, 0 for its logarithm.
  FaceCoordinates(int faces, int columns, Real rest)
      : blocks_((faces + faceLanes - 1) / faceLanes), rest_(rest), storedAs_(columns, -1) {}

  /// Allocates all columns for set().
  void store() {
    stored_ = columns();
    for (int c = 0; c < stored_; ++c) storedAs_[c] = c;
    data_.assign(static_cast<std::size_t>(blocks_) * blockSize(), Real(0));
    if (rest_ == 0) return;
    for (std::size_t at = 0; at < data_.size(); at += numbersPerFace * faceLanes)
      for (int k = 0; k < numbersPerFace; ++k) std::fill_n(&data_[at + k * faceLanes], faceLanes, restOf(k));
  }

  int columns() const { return static_cast<int>(storedAs_.size()); }
  /// Position of a face in the blocks: block slot / faceLanes, lane slot % faceLanes.
  int slot(int face) const { return face < static_cast<int>(slot_.size()) ? slot_[face] : face; }
  void set(int face, int column, int number, Real value) {
    data_[index(slot(face), storedAs_[column], number)] = value;
  }
  Real at(int face, int column, int number) const {
    return storedAs_[column] < 0 ? restOf(number) : data_[index(slot(face), storedAs_[column], number)];
  }
  /// The stored columns of four faces.
  const Real* block(int block) const { return data_.data() + static_cast<std::size_t>(block) * blockSize(); }

  ColumnWeights<Real> weights(const PoseWeights& poses) const { return weights(std::span(&poses, 1)); }

  /// partOf: part of each local frame; empty with one part. Beyond the keys, there is one part.
  [[gnu::noinline]] ColumnWeights<Real> weights(std::span<const PoseWeights> parts,
                                                std::span<const int> partOf = {}) const {
    ColumnWeights<Real> result;
    result.partOf = partOf;
    const auto weightOf = [](const PoseWeights& part, int c) { return part.column[c] - (c == part.beyond ? 1 : 0); };
    const auto add = [&](Real weight) {
      for (int i = 0; i < faceLanes; ++i) result.lanes.push_back(weight);
    };
    std::vector<int> used;
    for (int c = 0; c < columns(); ++c) {
      bool counts = false;
      for (const PoseWeights& part : parts) counts = counts || std::abs(weightOf(part, c)) >= minWeight<Real>;
      if (storedAs_[c] < 0 || !counts) continue;
      used.push_back(c);
      result.stored.push_back(storedAs_[c]);
    }
    for (const PoseWeights& part : parts) {
      for (const int c : used) add(static_cast<Real>(weightOf(part, c)));
      double atRest = 0;
      for (int c = 0; c < columns(); ++c)
        if (storedAs_[c] < 0) atRest += weightOf(part, c);
      add(static_cast<Real>(atRest) * rest_);
    }
    const PoseWeights& poses = parts.front();
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

  /// Removes a column in which every face rests exactly.
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

  /// Reorders the faces within the blocks: order[i] is the new face in slot i. Works column by column, to copy only one
  /// column at a time. May be called only once.
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
  std::vector<int> storedAs_;  // stored index of each column, or -1
  std::vector<int> slot_;      // slot of each face; empty in mesh order
  std::vector<Real> data_;
};

}  // namespace shapespline
