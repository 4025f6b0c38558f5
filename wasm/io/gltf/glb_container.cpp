#include "io/gltf/glb_container.h"

#include <cstring>

#include "core/base/format.h"
#include "io/base/byte_text.h"

namespace shapespline {

namespace {

constexpr std::size_t headerBytes = 12, chunkHeader = 8;
constexpr std::uint32_t jsonChunk = 0x4E4F534A, binChunk = 0x004E4942;

std::uint32_t word(std::span<const std::uint8_t> bytes, std::size_t at) {
  return bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16 | static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

Error truncated(const std::string& where, std::uint64_t declared, std::size_t have) {
  return {ErrorCode::TruncatedFile, where + " is cut off: it declares " + sizeText(declared) + " but has only " +
                                        sizeText(have) + ". Copy or export it again."};
}

Error brokenGlb(const std::string& where, const std::string& what) {
  return {ErrorCode::MalformedFile, where + " is a broken GLB: " + what + ". Export it again."};
}

}  // namespace

bool isGlb(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
}

Result<GlbChunks> splitGlb(std::span<const std::uint8_t> bytes, const std::string& where) {
  if (bytes.size() < headerBytes) return truncated(where, headerBytes, bytes.size());
  const std::uint32_t version = word(bytes, 4), length = word(bytes, 8);
  if (version != 2)
    return Error{ErrorCode::Unsupported, where + " is glTF version " + std::to_string(version) +
                                             "; only 2.0 is supported. Export it as glTF 2.0."};
  if (length > bytes.size()) return truncated(where, length, bytes.size());
  if (length < headerBytes + chunkHeader) return brokenGlb(where, "it has no JSON chunk");

  GlbChunks chunks;
  int index = 0;
  for (std::size_t at = headerBytes; at < length; ++index) {
    if (length - at < chunkHeader)
      return brokenGlb(where, "the header of chunk " + std::to_string(index) + " is cut off");
    const std::uint32_t size = word(bytes, at), type = word(bytes, at + 4);
    at += chunkHeader;
    if (size > length - at)
      return brokenGlb(where, "chunk " + std::to_string(index) + " declares " + sizeText(size) + " but only " +
                                  sizeText(length - at) + " are left");
    const auto content = bytes.subspan(at, size);
    at += size;
    if (index == 0 && type != jsonChunk) return brokenGlb(where, "its first chunk is not JSON");
    if (index > 0 && type == jsonChunk) return brokenGlb(where, "it has two JSON chunks");
    if (index == 0) chunks.json = {reinterpret_cast<const char*>(content.data()), content.size()};
    if (type == binChunk && index != 1) return brokenGlb(where, "its BIN chunk is not the second chunk");
    if (type == binChunk) {
      chunks.bin = content;
      chunks.hasBin = true;
    }
  }
  return chunks;
}

}  // namespace shapespline
