// Shapes far from the origin: one offset is subtracted from all keys in double precision, so they fit single precision.
#pragma once

#include <span>
#include <string>

#include "core/base/status.h"
#include "io/base/imported.h"

namespace shapespline {

/// Zero unless the box around all poses lies more than 16 diagonals from the origin. Otherwise the centre of the box,
/// rounded to a power of two near the diagonal, so the subtraction is exact.
Vec3 chooseOffset(std::span<const Key> keys);

/// Subtracts the offset that was asked for, that of a saved project where its keys still lie there, or else the chosen
/// one, from all keys and keeps it as the import's. Error: TooLarge for coordinates that single precision cannot
/// compute with.
Status subtractOffset(Import& import, const ImportOptions& options);

/// Warns where single precision rounds a key visibly: as its file stores it, or because the keys lie far apart.
void warnOfRounding(Import& import);

}  // namespace shapespline
