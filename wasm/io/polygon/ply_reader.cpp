// Stanford PLY. We use our own reader because packaged libraries read through streams and allocate whatever size the
// header declares.
#include <algorithm>
#include <bit>
#include <cstring>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/base/limits.h"
#include "io/polygon/ply_header.h"
#include "io/polygon/polygon_readers.h"
#include "io/polygon/vertex_colors.h"

namespace shapespline {

namespace {

// Reads the values after the header in sequence, in any format.
class ValueReader {
 public:
  ValueReader(PlyFormat format, std::string_view rest) : format_(format), rest_(rest) {}

  // False at the end of the file, or if a word is not a number.
  bool next(PlyType type, double& value) {
    return format_ == PlyFormat::Ascii ? nextWord(value) : nextBytes(type, value);
  }

  std::size_t left() const { return rest_.size(); }

  // Whether reading the last value stopped at a decimal comma.
  bool stoppedAtComma() const {
    return format_ == PlyFormat::Ascii && hasDecimalComma(rest_.substr(0, rest_.find_first_of("\r\n")));
  }

  // Minimum number of bytes of a value.
  std::size_t least(PlyType type) const { return format_ == PlyFormat::Ascii ? 1 : plyTypeBytes(type); }

 private:
  bool nextWord(double& value) {
    const std::size_t start = rest_.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos) return false;
    rest_.remove_prefix(start);
    const std::size_t end = std::min(rest_.find_first_of(" \t\r\n"), rest_.size());
    if (!parseNumber(rest_.substr(0, end), value)) return false;
    rest_.remove_prefix(end);
    return true;
  }

  template <class T>
  static double load(const std::uint8_t* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
  }

  bool nextBytes(PlyType type, double& value) {
    const std::size_t size = plyTypeBytes(type);
    if (size > rest_.size()) return false;
    std::uint8_t bytes[8];
    std::memcpy(bytes, rest_.data(), size);
    rest_.remove_prefix(size);
    if (format_ == PlyFormat::BigEndian) std::reverse(bytes, bytes + size);
    switch (type) {
      case PlyType::Int8: value = load<std::int8_t>(bytes); break;
      case PlyType::UInt8: value = load<std::uint8_t>(bytes); break;
      case PlyType::Int16: value = load<std::int16_t>(bytes); break;
      case PlyType::UInt16: value = load<std::uint16_t>(bytes); break;
      case PlyType::Int32: value = load<std::int32_t>(bytes); break;
      case PlyType::UInt32: value = load<std::uint32_t>(bytes); break;
      case PlyType::Float32: value = load<float>(bytes); break;
      case PlyType::Float64: value = load<double>(bytes); break;
    }
    return true;
  }

  PlyFormat format_;
  std::string_view rest_;
};

// Destination of a vertex property: position, normal, coordinates or colour; -1 for none.
enum Slot { X, Y, Z, NormalX, NormalY, NormalZ, U, V, Red, Green, Blue, Alpha, slotCount };

int slotOf(const std::string& name) {
  static constexpr std::pair<std::string_view, Slot> propertyNames[] = {{"x", X},
                                                                        {"y", Y},
                                                                        {"z", Z},
                                                                        {"nx", NormalX},
                                                                        {"ny", NormalY},
                                                                        {"nz", NormalZ},
                                                                        {"u", U},
                                                                        {"v", V},
                                                                        {"s", U},
                                                                        {"t", V},
                                                                        {"texture_u", U},
                                                                        {"texture_v", V},
                                                                        {"red", Red},
                                                                        {"green", Green},
                                                                        {"blue", Blue},
                                                                        {"alpha", Alpha},
                                                                        {"r", Red},
                                                                        {"g", Green},
                                                                        {"b", Blue},
                                                                        {"a", Alpha},
                                                                        {"diffuse_red", Red},
                                                                        {"diffuse_green", Green},
                                                                        {"diffuse_blue", Blue},
                                                                        {"diffuse_alpha", Alpha}};
  const std::string lower = lowerCase(name);
  for (const auto& [text, slot] : propertyNames)
    if (text == lower) return slot;
  return -1;
}

ColorType colorTypeOf(PlyType type) {
  if (type == PlyType::Int8 || type == PlyType::UInt8) return ColorType::Byte;
  return type == PlyType::Float32 || type == PlyType::Float64 ? ColorType::Any : ColorType::Integer;
}

struct PlyReader {
  const std::string& where;
  ValueReader values;
  const FractionReport& onProgress;
  PolygonMesh mesh;
  std::size_t size = values.left();  // measured before reading
  int leftOut = 0;
  std::vector<float> colors{};  // as in the file, 4 per vertex

  Error cutOff(const PlyElement& element, std::int64_t have) const {
    if (values.stoppedAtComma()) return decimalComma(where);
    return {ErrorCode::TruncatedFile, where + " is cut off or broken: it declares " + grouped(element.count) + " " +
                                          inQuotes(element.name) + " elements but contains at most " + grouped(have) +
                                          ". Copy or export it again."};
  }

  void reportRow(std::int64_t row) const {
    if (row % 16384 == 0)
      reportFraction(onProgress, 1 - static_cast<double>(values.left()) / static_cast<double>(size));
  }

  // Rejects counts larger than the rest of the file, before allocating memory.
  Status checkCount(const PlyElement& element) const {
    std::uint64_t least = 0;
    for (const PlyProperty& p : element.properties) least += values.least(p.isList ? p.countType : p.type);
    const auto count = static_cast<std::uint64_t>(element.count);
    if (count > maxElements * 4)
      return Error{ErrorCode::TooLarge, where + " declares " + grouped(element.count) + " " + inQuotes(element.name) +
                                            " elements, more than is supported. Simplify the mesh first."};
    if (count * least > values.left())
      return cutOff(element, static_cast<std::int64_t>(values.left() / std::max<std::uint64_t>(least, 1)));
    return {};
  }

  // Reads one property and passes its value, or each value of a list, to `take`.
  template <class Take>
  bool readProperty(const PlyProperty& p, Take take) {
    double value = 0;
    if (!p.isList) {
      if (!values.next(p.type, value)) return false;
      take(value);
      return true;
    }
    double count = 0;
    if (!values.next(p.countType, count) || !(count >= 0) || count > static_cast<double>(values.left())) return false;
    for (double i = 0; i < count; ++i) {
      if (!values.next(p.type, value)) return false;
      take(value);
    }
    return true;
  }

  void addVertex(const double* slot, const bool* has) {
    mesh.positions.emplace_back(slot + X);
    if (has[NormalX] && has[NormalY] && has[NormalZ]) mesh.normals.push_back(Vec3(slot + NormalX).normalized());
    if (has[U] && has[V]) {
      const auto finite = [](double value) { return std::abs(value) < 1e6 ? static_cast<float>(value) : 0; };
      mesh.scene.uvs.push_back(finite(slot[U]));
      mesh.scene.uvs.push_back(finite(1 - slot[V]));  // PLY counts v from below
    }
    if (!has[Red] || !has[Green] || !has[Blue]) return;
    for (int c = Red; c <= Alpha; ++c) colors.push_back(c < Alpha || has[Alpha] ? static_cast<float>(slot[c]) : 1);
  }

  Status readVertices(const PlyElement& element) {
    if (!mesh.positions.empty())  // a second vertex element might have other properties
      return Error{ErrorCode::MalformedFile, where + " declares its vertices twice. Export the file again."};
    bool has[slotCount] = {};
    std::vector<int> slots;
    ColorType rgb = ColorType::Any, opacity = ColorType::Any;
    for (const PlyProperty& p : element.properties) {
      slots.push_back(p.isList ? -1 : slotOf(p.name));
      if (slots.back() >= 0) has[slots.back()] = true;
      if (slots.back() == Red) rgb = colorTypeOf(p.type);
      if (slots.back() == Alpha) opacity = colorTypeOf(p.type);
    }
    if (!has[X] || !has[Y] || !has[Z])
      return Error{ErrorCode::MalformedFile,
                   where + ": its vertices need the properties x, y and z. Export the file again."};
    if (element.count > static_cast<std::int64_t>(maxElements))
      return Error{ErrorCode::TooLarge, where + " has " + grouped(element.count) +
                                            " vertices, more than is supported. Simplify the mesh first."};
    mesh.positions.reserve(element.count);
    for (std::int64_t i = 0; i < element.count; ++i) {
      reportRow(i);
      double slot[slotCount] = {};
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& p = element.properties[k];
        const bool read = readProperty(p, [&](double value) {
          if (slots[k] >= 0) slot[slots[k]] = value;
        });
        if (!read) return cutOff(element, i);
      }
      addVertex(slot, has);
    }
    if (!colors.empty()) setColors(mesh, std::move(colors), rgb, opacity);
    return {};
  }

  void finishFace(std::size_t start) {
    if (mesh.corners.size() - start >= 3) {
      mesh.ends.push_back(static_cast<int>(mesh.corners.size()));
    } else {
      mesh.corners.resize(start);
      ++leftOut;
    }
  }

  static bool isCorners(const PlyProperty& p) {
    return p.isList && (p.name == "vertex_indices" || p.name == "vertex_index");
  }

  static bool isFaceColor(const PlyProperty& p) { return !p.isList && slotOf(p.name) == Red; }

  static int vertexOf(double value) { return value >= 0 && value < 0x7fffffff ? static_cast<int>(value) : -1; }

  Status checkCorners() const {
    if (mesh.corners.size() <= 0x7fffffff / 2) return {};
    return Error{ErrorCode::TooLarge, where + " has too many faces. Simplify the mesh first."};
  }

  Status readFaces(const PlyElement& element) {
    for (std::int64_t i = 0; i < element.count; ++i) {
      reportRow(i);
      const std::size_t start = mesh.corners.size();
      for (const PlyProperty& p : element.properties) {
        const bool read = readProperty(p, [&](double value) {
          if (isCorners(p)) mesh.corners.push_back(vertexOf(value));
        });
        if (!read) return cutOff(element, i);
      }
      finishFace(start);
      if (Status count = checkCorners(); !count) return count;
    }
    return {};
  }

  // Every corner of a strip from the third on forms a triangle with the two corners before it.
  struct Strip {
    int length = 0;
    int before[2] = {-1, -1};
  };

  // -1 ends a strip. Unsigned types use their largest number instead.
  bool endsStrip(PlyType type, double value) const {
    if (value == -1) return true;
    const double largest = type == PlyType::UInt32   ? 0xffffffff
                           : type == PlyType::UInt16 ? 0xffff
                           : type == PlyType::UInt8  ? 0xff
                                                     : -1;
    return value == largest && value >= static_cast<double>(mesh.positions.size());
  }

  // Reverses every other triangle. Triangles that repeat a vertex only connect two parts.
  void addToStrip(Strip& strip, int vertex) {
    const auto [a, b] = strip.before;
    if (++strip.length >= 3 && (vertex < 0 || (a != b && b != vertex && vertex != a))) {
      const bool turned = strip.length % 2 == 0;
      mesh.corners.insert(mesh.corners.end(), {turned ? b : a, turned ? a : b, vertex});
      mesh.ends.push_back(static_cast<int>(mesh.corners.size()));
    }
    strip.before[0] = b;
    strip.before[1] = vertex;
  }

  Status readStrips(const PlyElement& element) {
    for (std::int64_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& p : element.properties) {
        Strip strip;
        const bool read = readProperty(p, [&](double value) {
          if (!isCorners(p)) return;
          if (endsStrip(p.type, value)) strip = {};
          else addToStrip(strip, vertexOf(value));
        });
        if (!read) return cutOff(element, i);
      }
      if (Status count = checkCorners(); !count) return count;
    }
    return {};
  }

  Status skip(const PlyElement& element) {
    for (std::int64_t i = 0; i < element.count; ++i) {
      reportRow(i);
      for (const PlyProperty& p : element.properties)
        if (!readProperty(p, [](double) {})) return cutOff(element, i);
    }
    return {};
  }

  Result<PolygonMesh> read(const PlyHeader& header) {
    for (const PlyElement& element : header.elements) {
      // Elements without properties have no bytes, whatever their count.
      if (element.properties.empty() && element.name != "vertex") continue;
      if (Status count = checkCount(element); !count) return count.error();
      Status status = element.name == "vertex"      ? readVertices(element)
                      : element.name == "face"      ? readFaces(element)
                      : element.name == "tristrips" ? readStrips(element)
                                                    : skip(element);
      if (!status) return status.error();
    }
    if (Status polygons = checkPolygons(mesh, where); !polygons) return polygons.error();
    mesh.scene.groups = {{0, mesh.polygonCount(), -1}};
    mesh.writtenZUp = header.byBlender;
    warnOfLeftOut(mesh, leftOut, where);
    for (const PlyElement& element : header.elements)
      if (element.name == "face" && std::any_of(element.properties.begin(), element.properties.end(), isFaceColor))
        warnOfFaceColors(mesh, where);
    return std::move(mesh);
  }
};

}  // namespace

Result<PolygonMesh> readPly(const NamedBytes& file, const std::string& where, const FractionReport& onProgress) {
  LineReader lines(file.bytes);
  const auto header = readPlyHeader(lines, where);
  if (!header) return header.error();
  return PlyReader{where, ValueReader(header->format, lines.rest()), onProgress, {}}.read(*header);
}

}  // namespace shapespline
