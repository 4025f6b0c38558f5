// What makes the approximate shapes of a sequence.
#pragma once

#include "core/reconstruct/preview_embedding.h"
#include "core/sequence/encoded_shape.h"

namespace shapespline {

/// The shape's vertices, embedded in its frames. Error: that of the solver.
Result<PreviewEmbedding> makePreview(const EncodedShape& encoded);

/// The same of patches alone, each a rigid piece in its frame, in the order of the welded vertices.
Result<PreviewEmbedding> makePatchPreview(const PatchedShape& patched);

}  // namespace shapespline
