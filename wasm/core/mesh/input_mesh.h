// The input's vertices and faces, and their relation to the welded mesh.
#pragma once

#include <vector>

#include "core/base/types.h"
#include "core/mesh/weld.h"

namespace shapespline {

struct InputMesh {
  std::vector<Triangle> faces;
  Welding welding;               ///< welds the vertices
  std::vector<int> inputFaceOf;  ///< input face of each welded face
  bool mirrored = false;         ///< the winding of welded faces is reversed

  int vertexCount() const { return static_cast<int>(welding.weldedOfRaw.size()); }

  /// Reorders values of welded faces to the input's face order.
  std::vector<int> ofInputFaces(const std::vector<int>& ofFaces) const {
    std::vector<int> result(ofFaces.size());
    for (std::size_t f = 0; f < ofFaces.size(); ++f) result[inputFaceOf[f]] = ofFaces[f];
    return result;
  }
};

}  // namespace shapespline
