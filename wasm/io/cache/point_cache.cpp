#include "io/cache/point_cache.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>

#include "core/base/format.h"
#include "io/base/byte_text.h"

namespace shapespline {

namespace {

constexpr std::string_view pc2Mark("POINTCACHE2\0", 12);
constexpr std::size_t pc2Header = 32, mddHeader = 8, pointBytes = 12;

std::uint32_t wordAt(std::span<const std::uint8_t> bytes, std::size_t at, bool bigEndian) {
  const std::uint8_t* b = &bytes[at];
  return bigEndian ? static_cast<std::uint32_t>(b[0]) << 24 | b[1] << 16 | b[2] << 8 | b[3]
                   : static_cast<std::uint32_t>(b[3]) << 24 | b[2] << 16 | b[1] << 8 | b[0];
}

double floatAt(std::span<const std::uint8_t> bytes, std::size_t at, bool bigEndian) {
  return std::bit_cast<float>(wordAt(bytes, at, bigEndian));
}

// `header`: number of bytes before the points.
Status checkSize(const NamedBytes& file, std::uint64_t header, std::uint64_t frames, std::uint64_t points,
                 const std::string& where) {
  if (frames == 0 || points == 0)
    return Error{ErrorCode::MalformedFile, where + " has no points. Export the cache again."};
  // Both are below 2^32, so only the product with the size of a point could overflow.
  const std::uint64_t size = file.bytes.size();
  if (header <= size && frames * points <= (size - header) / pointBytes) return {};
  return Error{ErrorCode::TruncatedFile,
               where + " is cut off or broken: it declares " + grouped(static_cast<std::int64_t>(frames)) +
                   " frames of " + grouped(static_cast<std::int64_t>(points)) +
                   " points, 12 bytes each, but has only " + sizeText(size) + ". Copy or export it again."};
}

bool increase(const std::vector<double>& times) {
  for (std::size_t i = 0; i < times.size(); ++i)
    if (!std::isfinite(times[i]) || (i > 0 && !(times[i] > times[i - 1]))) return false;
  return true;
}

// Times of evenly spaced frames, `step` frames apart.
std::vector<double> frameTimes(std::uint64_t count, double start, double step) {
  std::vector<double> seconds(count);
  for (std::size_t i = 0; i < count; ++i) seconds[i] = (start + static_cast<double>(i) * step) / framesPerSecond;
  return increase(seconds) ? seconds : frameTimes(count, 0, 1);
}

}  // namespace

Positions PointCache::frame(std::size_t index) const {
  Positions out(points);
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t c = 0; c < 3; ++c)
      out[p][static_cast<int>(c)] = floatAt(numbers, pointBytes * (index * points + p) + 4 * c, bigEndian);
  return out;
}

bool isPc2(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= pc2Mark.size() && std::memcmp(bytes.data(), pc2Mark.data(), pc2Mark.size()) == 0;
}

Result<PointCache> readPc2(const NamedBytes& file, const std::string& where) {
  if (file.bytes.size() < pc2Header)
    return Error{ErrorCode::TruncatedFile, where + " is cut off in its header. Copy or export it again."};
  const std::uint64_t points = wordAt(file.bytes, 16, false), frames = wordAt(file.bytes, 28, false);
  if (Status size = checkSize(file, pc2Header, frames, points, where); !size) return size.error();
  const double start = floatAt(file.bytes, 20, false), step = floatAt(file.bytes, 24, false);
  return PointCache{frameTimes(frames, start, step), static_cast<std::size_t>(points), file.bytes.subspan(pc2Header),
                    false};
}

Result<PointCache> readMdd(const NamedBytes& file, const std::string& where) {
  if (file.bytes.size() < mddHeader)
    return Error{ErrorCode::TruncatedFile, where + " is cut off in its header. Copy or export it again."};
  const std::uint64_t frames = wordAt(file.bytes, 0, true), points = wordAt(file.bytes, 4, true);
  const std::uint64_t header = mddHeader + 4 * frames;
  if (Status size = checkSize(file, header, frames, points, where); !size) return size.error();
  std::vector<double> seconds(frames);
  for (std::size_t i = 0; i < frames; ++i) seconds[i] = floatAt(file.bytes, mddHeader + 4 * i, true);
  if (!increase(seconds)) seconds = frameTimes(frames, 0, 1);
  return PointCache{std::move(seconds), static_cast<std::size_t>(points), file.bytes.subspan(header), true};
}

}  // namespace shapespline
