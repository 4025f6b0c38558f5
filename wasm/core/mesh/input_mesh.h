// The input's own vertices and faces, and how they belong to the welded mesh.
#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/mesh/weld.h"

namespace shapespline {

struct InputMesh {
  std::vector<Triangle> faces;
  Welding welding;               ///< of the vertices
  std::vector<int> inputFaceOf;  ///< of each welded face
  bool mirrored = false;         ///< welded faces run the other way round

  int vertexCount() const { return static_cast<int>(welding.weldedOfRaw.size()); }

  /// Values of the welded mesh's faces, in the order of the input's.
  std::vector<int> ofInputFaces(const std::vector<int>& ofFaces) const {
    std::vector<int> result(ofFaces.size());
    for (std::size_t f = 0; f < ofFaces.size(); ++f) result[inputFaceOf[f]] = ofFaces[f];
    return result;
  }
};

}  // namespace shapespline
