// Reads PC2 and MDD: vertices of a mesh over time.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/status.h"
#include "core/base/types.h"
#include "io/base/named_bytes.h"

namespace shapespline {

/// Frame rate for files that state the number of frames but no duration.
constexpr double framesPerSecond = 24;

/// A point cache whose counts match its bytes. The bytes must outlive it.
struct PointCache {
  std::vector<double> seconds;  ///< time of each frame, increasing
  std::size_t points = 0;
  std::span<const std::uint8_t> numbers;  ///< 12 bytes per point and frame: float32 x, y, z
  bool bigEndian = false;

  /// n positions, in the file's axes.
  Positions frame(std::size_t index) const;
};

/// PC2 (3ds Max, Maya, Blender): little endian, times in frames. Errors: MalformedFile, TruncatedFile.
Result<PointCache> readPc2(const NamedBytes& file, const std::string& where);

/// MDD (LightWave, Blender): big endian, times in seconds. Times that do not increase are replaced by frame numbers.
/// Errors as above.
Result<PointCache> readMdd(const NamedBytes& file, const std::string& where);

/// Whether the bytes start with PC2's signature. MDD has none.
bool isPc2(std::span<const std::uint8_t> bytes);

}  // namespace shapespline
