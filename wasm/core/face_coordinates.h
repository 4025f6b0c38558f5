// The per-face part of the coordinates, laid out for the frame kernel: it is what a frame streams through memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/types.h"

namespace shapespline {

/// Numbers of a face and column: log(G_p(f)^T R_f) (3), then S_f or log S_f as xx, xy, yy in the reference tangent frame.
inline constexpr int numbersPerFace = 6;

/// Faces side by side in one vector register.
inline constexpr int faceLanes = 4;

/// What a frame takes of the columns: a weight for each that is stored, and what those at rest add to the diagonal of S_f.
template <class Real>
struct ColumnWeights {
  std::vector<Real> stored;
  Real atRest = 0;
};

/// Six numbers for each face and column, in blocks of four faces: [block][column][number][lane], so that a frame reads
/// them once, forwards. The last block is padded. Faces lie in their own order until they are reordered. A column in which
/// every face rests, as in the reference pose, is not stored.
template <class Real>
class FaceCoordinates {
 public:
  FaceCoordinates() = default;

  /// All faces at rest: no rotation, and a diagonal of `rest`, 1 for S_f = I and 0 for its logarithm.
  FaceCoordinates(int faces, int columns, Real rest)
      : blocks_((faces + faceLanes - 1) / faceLanes), rest_(rest), place_(columns, -1) {}

  /// Makes room for what set() writes, in every column.
  void store() {
    stored_ = columns();
    for (int c = 0; c < stored_; ++c) place_[c] = c;
    data_.resize(static_cast<std::size_t>(blocks_) * blockSize());
    for (std::size_t i = 0; i < data_.size(); ++i) data_[i] = restOf(static_cast<int>(i / faceLanes % numbersPerFace));
  }

  int columns() const { return static_cast<int>(place_.size()); }
  /// Where a face lies in the blocks: block slot / faceLanes, lane slot % faceLanes.
  int slot(int face) const { return face < static_cast<int>(slot_.size()) ? slot_[face] : face; }
  void set(int face, int column, int number, Real value) { data_[index(slot(face), place_[column], number)] = value; }
  Real at(int face, int column, int number) const {
    return place_[column] < 0 ? restOf(number) : data_[index(slot(face), place_[column], number)];
  }
  /// The stored columns of four faces.
  const Real* block(int block) const { return data_.data() + static_cast<std::size_t>(block) * blockSize(); }

  ColumnWeights<Real> weights(const std::vector<double>& ofColumns) const {
    ColumnWeights<Real> result;
    double atRest = 0;
    for (int c = 0; c < columns(); ++c) {
      if (place_[c] < 0) atRest += ofColumns[c];
      else result.stored.push_back(static_cast<Real>(ofColumns[c]));
    }
    result.atRest = static_cast<Real>(atRest) * rest_;
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
    const int dropped = place_[column];
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
    place_[column] = -1;
    for (int& place : place_)
      if (place > dropped) --place;
    --stored_;
  }

  /// Moves the faces within the blocks, without a second copy of them: order[i] is the face that comes to slot i. Once only.
  void reorder(const std::vector<int>& order) {
    slot_.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) slot_[order[i]] = static_cast<int>(i);
    const int numbers = stored_ * numbersPerFace;
    std::vector<char> done(order.size(), 0);
    std::vector<Real> kept(numbers);
    const auto entry = [&](int slot, int k) -> Real& { return data_[index(slot, 0, k)]; };
    for (int start = 0; start < static_cast<int>(order.size()); ++start) {
      if (done[start]) continue;
      for (int k = 0; k < numbers; ++k) kept[k] = entry(start, k);
      int to = start;
      for (; order[to] != start; to = order[to]) {
        done[to] = 1;
        for (int k = 0; k < numbers; ++k) entry(to, k) = entry(order[to], k);
      }
      done[to] = 1;
      for (int k = 0; k < numbers; ++k) entry(to, k) = kept[k];
    }
  }

 private:
  Real restOf(int number) const { return number == 3 || number == 5 ? rest_ : Real(0); }
  std::size_t blockSize() const { return static_cast<std::size_t>(stored_) * numbersPerFace * faceLanes; }
  std::size_t index(int slot, int place, int number) const {
    return static_cast<std::size_t>(slot / faceLanes) * blockSize() +
           (static_cast<std::size_t>(place) * numbersPerFace + number) * faceLanes + slot % faceLanes;
  }

  int blocks_ = 0, stored_ = 0;
  Real rest_ = 0;
  std::vector<int> place_;  // of each column among the stored ones, or -1
  std::vector<int> slot_;   // of each face; empty while they lie in their own order
  std::vector<Real> data_;
};

}  // namespace shapespline
