// What makes the approximate shapes of a sequence.
#pragma once

#include "core/reconstruct/preview_embedding.h"
#include "core/sequence/encoded_shape.h"

namespace shapespline {

/// The shape's vertices, embedded in its frames. Error: that of the solver.
Result<PreviewEmbedding> makePreview(const EncodedShape& encoded);

}  // namespace shapespline
