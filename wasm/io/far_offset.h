// Moves shapes that are far from the origin: subtracts one offset from all keys in double precision, so they fit single
// precision.
#pragma once

#include <span>
#include <string>

#include "core/base/status.h"
#include "io/base/imported.h"

namespace shapespline {

/// Zero unless the centre of the box around all poses is, along some axis, more than 16 diagonals from the origin.
/// Otherwise this centre, rounded to multiples of a power of two near the diagonal. The subtraction is then exact.
Vec3 chooseOffset(std::span<const Key> keys);

/// Subtracts one offset from all keys and stores it in the import. Uses the requested offset, else the saved project's
/// offset if its keys are still close, else the computed one. Error: TooLarge for coordinates beyond single precision.
Status subtractOffset(Import& import, const ImportOptions& options);

/// Warns if single precision rounds a key visibly, in its file or because the keys are far apart.
void warnOfRounding(Import& import);

}  // namespace shapespline
