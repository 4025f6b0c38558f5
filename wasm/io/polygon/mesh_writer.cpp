// OBJ and PLY, both in the input's own vertices and faces.
#include "io/polygon/mesh_writer.h"

#include <charconv>
#include <cstring>

namespace shapespline {

namespace {

// Appends text and numbers; the shortest text that reads back as the same float.
struct TextSink {
  std::vector<std::uint8_t>& out;

  void text(std::string_view s) { out.insert(out.end(), s.begin(), s.end()); }

  template <class Number>
  void number(Number value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    out.insert(out.end(), buffer, end);
  }
};

template <class T>
void appendBytes(std::vector<std::uint8_t>& out, T value) {
  std::uint8_t bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.insert(out.end(), bytes, bytes + sizeof value);
}

}  // namespace

std::vector<std::uint8_t> writeObj(std::span<const float> positions, const std::vector<Triangle>& faces,
                                   const Scene& scene) {
  std::vector<std::uint8_t> out;
  out.reserve(positions.size() * 12 + scene.uvs.size() * 12 + faces.size() * (scene.uvs.empty() ? 24 : 45));
  TextSink sink{out};
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
    sink.text("v");
    for (int c = 0; c < 3; ++c) sink.text(" "), sink.number(positions[i + c]);
    sink.text("\n");
  }
  for (std::size_t i = 0; i + 1 < scene.uvs.size(); i += 2) {
    sink.text("vt "), sink.number(scene.uvs[i]), sink.text(" "),
        sink.number(1 - scene.uvs[i + 1]);  // counted from below
    sink.text("\n");
  }
  const std::vector<Triangle>& drawn = scene.seams.copyOf.empty() ? faces : scene.seams.faces;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    sink.text("f");
    for (int c = 0; c < 3; ++c) {
      sink.text(" "), sink.number(faces[f][c] + 1);
      if (!scene.uvs.empty()) sink.text("/"), sink.number(drawn[f][c] + 1);
    }
    sink.text("\n");
  }
  return out;
}

std::vector<std::uint8_t> writePly(std::span<const float> positions, const std::vector<Triangle>& faces) {
  std::vector<std::uint8_t> out;
  out.reserve(300 + positions.size() * 4 + faces.size() * 13);
  TextSink sink{out};
  sink.text("ply\nformat binary_little_endian 1.0\nelement vertex ");
  sink.number(positions.size() / 3);
  sink.text("\nproperty float x\nproperty float y\nproperty float z\nelement face ");
  sink.number(faces.size());
  sink.text("\nproperty list uchar int vertex_indices\nend_header\n");
  for (float value : positions) appendBytes(out, value);
  for (const Triangle& face : faces) {
    out.push_back(3);
    for (int v : face) appendBytes(out, static_cast<std::int32_t>(v));
  }
  return out;
}

}  // namespace shapespline
