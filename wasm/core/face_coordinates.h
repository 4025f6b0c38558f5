// The per-face part of the coordinates, laid out for the frame kernel: it is what a frame streams through memory.
#pragma once

#include <cstddef>
#include <vector>

#include "core/types.h"

namespace shapespline {

/// Numbers of a face and column: log(G_p(f)^T R_f) (3), then S_f or log S_f as xx, xy, yy in the reference tangent frame.
inline constexpr int numbersPerFace = 6;

/// Faces side by side in one vector register.
inline constexpr int faceLanes = 4;

/// Six numbers for each face and column, in blocks of four faces: [block][column][number][lane], so that a frame reads
/// them once, forwards. The last block is padded with zeros. Faces lie in their own order until they are reordered.
template <class Real>
class FaceCoordinates {
 public:
  FaceCoordinates() = default;
  FaceCoordinates(int faces, int columns)
      : blocks_((faces + faceLanes - 1) / faceLanes),
        columns_(columns),
        data_(static_cast<std::size_t>(blocks_) * blockSize(columns)) {}

  int columns() const { return columns_; }
  int paddedFaces() const { return blocks_ * faceLanes; }
  /// Where a face lies in the blocks: block slot / faceLanes, lane slot % faceLanes.
  int slot(int face) const { return face < static_cast<int>(slot_.size()) ? slot_[face] : face; }
  Real& at(int face, int column, int number) { return data_[index(slot(face), column, number)]; }
  Real at(int face, int column, int number) const { return data_[index(slot(face), column, number)]; }
  const Real* block(int block) const { return data_.data() + static_cast<std::size_t>(block) * blockSize(columns_); }

  Vec3 rotation(int face, int column) const {
    return {static_cast<double>(at(face, column, 0)), static_cast<double>(at(face, column, 1)),
            static_cast<double>(at(face, column, 2))};
  }
  /// Moves the faces within the blocks, without a second copy of them: order[i] is the face that comes to slot i. Once only.
  void reorder(const std::vector<int>& order) {
    slot_.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) slot_[order[i]] = static_cast<int>(i);
    const int numbers = columns_ * numbersPerFace;
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

  void setRotation(int face, int column, const Vec3& v) {
    for (int k = 0; k < 3; ++k) at(face, column, k) = static_cast<Real>(v[k]);
  }

 private:
  static std::size_t blockSize(int columns) { return static_cast<std::size_t>(columns) * numbersPerFace * faceLanes; }
  std::size_t index(int slot, int column, int number) const {
    return static_cast<std::size_t>(slot / faceLanes) * blockSize(columns_) +
           (static_cast<std::size_t>(column) * numbersPerFace + number) * faceLanes + slot % faceLanes;
  }

  int blocks_ = 0, columns_ = 0;
  std::vector<int> slot_;  // of each face; empty while they lie in their own order
  std::vector<Real> data_;
};

}  // namespace shapespline
