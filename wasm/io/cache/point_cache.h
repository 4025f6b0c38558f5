// PC2 and MDD: the vertices of a mesh over time.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"
#include "io/base/named_bytes.h"

namespace shapespline {

/// Frames of files that state their number, but not their duration.
constexpr double framesPerSecond = 24;

/// A cache whose counts fit its bytes, which must outlive it.
struct PointCache {
  std::vector<double> seconds;  ///< of each frame, increasing
  std::size_t points = 0;
  std::span<const std::uint8_t> numbers;  ///< 12 bytes per point and frame: float32 x, y, z
  bool bigEndian = false;

  /// n positions, in the file's own axes.
  Positions frame(std::size_t index) const;
};

/// PC2 (3ds Max, Maya, Blender): little endian, times in frames. Errors: MalformedFile, TruncatedFile.
Result<PointCache> readPc2(const NamedBytes& file, const std::string& where);

/// MDD (LightWave, Blender): big endian, times in seconds. Times that do not increase become frames. Errors as above.
Result<PointCache> readMdd(const NamedBytes& file, const std::string& where);

/// Whether the bytes begin as PC2 does. MDD has no such mark.
bool isPc2(std::span<const std::uint8_t> bytes);

}  // namespace shapespline
