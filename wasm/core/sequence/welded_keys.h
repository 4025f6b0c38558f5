// The keys as the method works on them: without copies of vertices, in the mesh's canonical order.
#pragma once

#include "core/base/progress.h"
#include "core/base/status.h"
#include "core/lri/welded_shape.h"
#include "core/sequence/input_mesh.h"
#include "core/sequence/keyframes.h"
#include "core/sequence/options.h"

namespace shapespline {

struct WeldedKeys {
  InputMesh input;
  WeldedShape shape;
  double diagonal = 0;  ///< the largest of one pose
};

/// keyframes: their poses are freed once they are welded. Errors: those of validate(), InvalidOption, and
/// VertexCountMismatch and NotFinite of tangent shapes.
Result<WeldedKeys> weldKeys(Keyframes keyframes, const EncodingOptions& options, const FractionReport& onProgress = {});

}  // namespace shapespline
