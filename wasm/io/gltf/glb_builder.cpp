#include "io/gltf/glb_builder.h"

#include <string>
#include <utility>

#include "io/base/byte_text.h"

namespace shapespline {

namespace {

// gltf_json reads whole numbers up to this limit. Other programs fail beyond it as well.
constexpr std::uint64_t maxGlbBytes = 0x7fffffff;

}  // namespace

// Inserts the header in place, so the bytes are held only once.
Result<std::vector<std::uint8_t>> GlbBuilder::finish() {
  align();
  doc["buffers"] = {{{"byteLength", bin.size()}}};
  std::string text = doc.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::uint64_t total = 12 + 8 + text.size() + 8 + bin.size();
  if (total > maxGlbBytes)
    return Error{ErrorCode::TooLarge, "The file would be " + sizeText(total) + ". A GLB of more than " +
                                          sizeText(maxGlbBytes) + " could not be opened again. Export fewer frames."};
  std::string head = "glTF";
  const auto word = [&](std::uint64_t value) {
    for (int shift = 0; shift < 32; shift += 8) head += static_cast<char>(value >> shift & 0xff);
  };
  word(2);
  word(total);
  word(text.size());
  head += "JSON" + text;
  word(bin.size());
  head += std::string("BIN\0", 4);
  bin.insert(bin.begin(), head.begin(), head.end());
  return std::move(bin);
}

}  // namespace shapespline
