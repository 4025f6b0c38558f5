// Writes OBJ and PLY with the input's vertices and faces.
#include "io/polygon/mesh_writer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

#include "io/base/byte_text.h"
#include "io/base/finite_shape.h"

namespace shapespline {

namespace {

// Appends text and numbers. Floats get the shortest text that reads back exactly.
struct TextSink {
  std::vector<std::uint8_t>& out;

  void text(std::string_view s) { out.insert(out.end(), s.begin(), s.end()); }

  template <class Number>
  void number(Number value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    out.insert(out.end(), buffer, end);
  }

  // Writes at most this number of decimals. Below 2^53 all digits are exact. A table for the shortest texts of doubles
  // would be larger than this file.
  void decimal(double value, int decimals) {
    const double scaled = std::round(std::abs(value) * std::pow(10.0, decimals));
    if (scaled == 0) return text("0");
    if (!(scaled < 0x1p63)) return number(static_cast<float>(value));
    char digits[32];
    char* end = std::to_chars(digits, digits + sizeof digits, static_cast<std::uint64_t>(scaled)).ptr;
    if (value < 0) text("-");
    if (end - digits <= decimals) {
      text("0.");
      for (auto zeros = decimals - (end - digits); zeros > 0; --zeros) text("0");
      while (end > digits + 1 && end[-1] == '0') --end;
      return text({digits, end});
    }
    char* const point = end - decimals;
    while (end > point && end[-1] == '0') --end;
    text({digits, point});
    if (end > point) text("."), text({point, end});
  }
};

// Decimals needed to distinguish numbers that differ by `step`, within double precision near `largest`.
int decimalsFor(double step, double largest) {
  const auto most = static_cast<int>(std::floor(std::log10(0x1p53 / largest)));
  return std::max(0, step > 0 ? std::min(static_cast<int>(std::ceil(-std::log10(step))), most) : most);
}

double largestOf(std::span<const float> values) {
  double largest = 0;
  for (float value : values) largest = std::max<double>(largest, std::abs(value));
  return largest;
}

template <class T>
void appendBytes(std::vector<std::uint8_t>& out, T value) {
  std::uint8_t bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.insert(out.end(), bytes, bytes + sizeof value);
}

using Edge = std::pair<int, int>;

// The corners of the polygon that was cut into these triangles, in order. Empty unless the polygon is simple.
std::vector<int> outline(std::span<const Triangle> triangles) {
  if (triangles.size() == 1) return {triangles[0].begin(), triangles[0].end()};
  std::vector<Edge> edges;
  for (const Triangle& t : triangles)
    for (int c = 0; c < 3; ++c) edges.emplace_back(t[c], t[(c + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> border;
  for (const auto& [a, b] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), Edge(b, a))) border.emplace_back(a, b);
  std::vector<int> corners;
  if (border.size() != triangles.size() + 2) return corners;
  for (int corner = triangles[0][0]; corners.size() < border.size();) {
    corners.push_back(corner);
    const auto edge = std::lower_bound(border.begin(), border.end(), Edge(corner, -1));
    if (edge == border.end() || edge->first != corner) return {};
    corner = edge->second;
    if ((corner == corners[0]) != (corners.size() == border.size())) return {};
  }
  return corners;
}

struct ObjWriter {
  TextSink sink;
  const std::vector<Triangle>& faces;
  const Scene& scene;
  const MaterialLibrary& library;
  bool hasNormals;
  bool hasNames;  // whether objects have names from the file
  std::size_t nextGroup = 0, nextObject = 0;

  bool hasUvs() const { return !scene.uvs.empty(); }
  bool hasSeams() const { return !scene.seams.copyOf.empty(); }

  void vectors(const char* name, std::span<const float> values) {
    for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
      sink.text(name);
      for (int c = 0; c < 3; ++c) {
        sink.text(" ");
        sink.number(values[i + c]);
      }
      sink.text("\n");
    }
  }

  void positions(std::span<const float> values, const MeshOffset& offset) {
    if (offset.value == Vec3::Zero() || !offset.added) return vectors("v", values);
    const double local = largestOf(values);
    int decimals[3];
    for (int c = 0; c < 3; ++c) decimals[c] = decimalsFor(local * 0x1p-24, local + std::abs(offset.value[c]));
    for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
      sink.text("v");
      for (int c = 0; c < 3; ++c) {
        sink.text(" ");
        if (offset.value[c] == 0) sink.number(values[i + c]);
        else sink.decimal(offset.value[c] + values[i + c], decimals[c]);
      }
      sink.text("\n");
    }
  }

  void comment(const MeshOffset& offset) {
    if (offset.value == Vec3::Zero() || offset.added) return;
    sink.text("# Positions here and in the point cache are relative to this offset: add it to them.\n");
    sink.text("# shapespline offset");
    for (double value : offset.value) {
      sink.text(" ");
      sink.decimal(value, decimalsFor(0, std::abs(value) + 1));
    }
    sink.text("\n");
  }

  void coordinates() {
    for (std::size_t i = 0; i + 1 < scene.uvs.size(); i += 2) {
      sink.text("vt ");
      sink.number(scene.uvs[i]);
      sink.text(" ");
      sink.number(1 - scene.uvs[i + 1]);  // OBJ counts v from below
      sink.text("\n");
    }
  }

  // Vertex copies are numbered after the mesh vertices.
  int vertexOf(int drawn) const {
    const int own = static_cast<int>(scene.uvs.size() / 2 - scene.seams.copyOf.size());
    return hasSeams() && drawn >= own ? scene.seams.copyOf[drawn - own] : drawn;
  }

  void corner(int drawn) {
    const int vertex = vertexOf(drawn) + 1;
    sink.text(" ");
    sink.number(vertex);
    if (hasUvs()) {
      sink.text("/");
      sink.number(drawn + 1);
    } else if (hasNormals) sink.text("/");
    if (hasNormals) {
      sink.text("/");
      sink.number(vertex);
    }
  }

  void face(std::span<const int> corners) {
    sink.text("f");
    for (int drawn : corners) corner(drawn);
    sink.text("\n");
  }

  void polygon(std::span<const Triangle> triangles) {
    if (const std::vector<int> corners = outline(triangles); !corners.empty()) return face(corners);
    for (const Triangle& triangle : triangles) face(triangle);
  }

  // Writes the material before the first face of each group. Groups are in face order.
  void material(std::size_t face) {
    for (; nextGroup < scene.groups.size(); ++nextGroup) {
      const MaterialGroup& group = scene.groups[nextGroup];
      if (static_cast<std::size_t>(group.start) > face) return;
      const bool known = group.material >= 0 && group.material < static_cast<int>(library.names.size());
      const std::string& name = known && !library.file.empty() ? library.names[group.material] : group.name;
      if (!name.empty()) named("usemtl ", name);
    }
  }

  // Writes the name before the first face of each object. Objects are in face order.
  void object(std::size_t face) {
    for (; nextObject < scene.objects.size(); ++nextObject) {
      const ObjectFaces& object = scene.objects[nextObject];
      if (static_cast<std::size_t>(object.start) > face) return;
      if (hasNames) named(object.isGroup ? "g " : "o ", object.name);
    }
  }

  // Sanitises a name: glTF allows any text.
  void named(const char* keyword, const std::string& name) {
    sink.text(keyword);
    sink.text(onOneLine(name));
    sink.text("\n");
  }

  void write(std::span<const float> values, std::span<const float> normals, const MeshOffset& offset) {
    comment(offset);
    if (!library.file.empty()) {
      sink.text("mtllib ");
      sink.text(library.file);
      sink.text("\n");
    }
    positions(values, offset);
    coordinates();
    vectors("vn", normals);
    const std::span<const Triangle> drawn(hasSeams() ? scene.seams.faces : faces);
    std::size_t next = 0;
    for (int count : scene.polygons) {
      if (count < 1 || next + count > drawn.size()) break;
      object(next);
      material(next);
      polygon(drawn.subspan(next, count));
      next += count;
    }
    for (; next < drawn.size(); ++next) {
      object(next);
      material(next);
      face(drawn[next]);
    }
  }
};

}  // namespace

Result<std::vector<std::uint8_t>> writeObj(std::span<const float> positions, const std::vector<Triangle>& faces,
                                           const Scene& scene, std::span<const float> normals,
                                           const MaterialLibrary& library, const MeshOffset& offset) {
  if (Status finite = checkFinite(positions, -1); !finite) return finite.error();
  std::vector<std::uint8_t> out;
  out.reserve(positions.size() * 12 + normals.size() * 12 + scene.uvs.size() * 12 + faces.size() * 45);
  const bool hasNames = std::any_of(scene.objects.begin(), scene.objects.end(), [](const ObjectFaces& object) {
    return !object.nodeName.empty() || !object.meshName.empty();
  });
  ObjWriter{{out}, faces, scene, library, !normals.empty(), hasNames}.write(positions, normals, offset);
  return out;
}

Result<std::vector<std::uint8_t>> writePly(std::span<const float> positions, const std::vector<Triangle>& faces,
                                           const MeshOffset& offset) {
  if (Status finite = checkFinite(positions, -1); !finite) return finite.error();
  const bool far = offset.value != Vec3::Zero();
  const std::string_view type = far ? "double" : "float";
  std::vector<std::uint8_t> out;
  out.reserve(300 + positions.size() * (far ? 8 : 4) + faces.size() * 13);
  TextSink sink{out};
  sink.text("ply\nformat binary_little_endian 1.0\nelement vertex ");
  sink.number(positions.size() / 3);
  for (std::string_view axis : {"x", "y", "z"}) {
    sink.text("\nproperty ");
    sink.text(type);
    sink.text(" ");
    sink.text(axis);
  }
  sink.text("\nelement face ");
  sink.number(faces.size());
  sink.text("\nproperty list uchar int vertex_indices\nend_header\n");
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (far) appendBytes(out, offset.value[static_cast<int>(i % 3)] + positions[i]);
    else appendBytes(out, positions[i]);
  }
  for (const Triangle& face : faces) {
    out.push_back(3);
    for (int v : face) appendBytes(out, static_cast<std::int32_t>(v));
  }
  return out;
}

}  // namespace shapespline
