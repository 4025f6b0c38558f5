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
/// them once, forwards. The last block is padded with zeros.
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
  Real& at(int face, int column, int number) { return data_[index(face, column, number)]; }
  Real at(int face, int column, int number) const { return data_[index(face, column, number)]; }
  const Real* block(int block) const { return data_.data() + static_cast<std::size_t>(block) * blockSize(columns_); }

  Vec3 rotation(int face, int column) const {
    return {static_cast<double>(at(face, column, 0)), static_cast<double>(at(face, column, 1)),
            static_cast<double>(at(face, column, 2))};
  }
  void setRotation(int face, int column, const Vec3& v) {
    for (int k = 0; k < 3; ++k) at(face, column, k) = static_cast<Real>(v[k]);
  }

 private:
  static std::size_t blockSize(int columns) { return static_cast<std::size_t>(columns) * numbersPerFace * faceLanes; }
  std::size_t index(int face, int column, int number) const {
    return static_cast<std::size_t>(face / faceLanes) * blockSize(columns_) +
           (static_cast<std::size_t>(column) * numbersPerFace + number) * faceLanes + face % faceLanes;
  }

  int blocks_ = 0, columns_ = 0;
  std::vector<Real> data_;
};

}  // namespace shapespline
