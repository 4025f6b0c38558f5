// Wavefront OBJ. We use our own reader because the common library reads through streams and triangulates polygons by
// each key's geometry, so two keys can get different triangles.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/base/image_type.h"
#include "io/base/limits.h"
#include "io/base/objects.h"
#include "io/base/uri.h"
#include "io/polygon/corner_coordinates.h"
#include "io/polygon/polygon_readers.h"
#include "io/polygon/text_reader.h"
#include "io/polygon/vertex_colors.h"

namespace shapespline {

namespace {

// A longer list of warnings would not help.
constexpr std::size_t maxWarnings = 100;
// Limits for material libraries of one file, and for words tried when searching a name with spaces.
constexpr std::size_t maxLibraries = 256;
constexpr int maxWords = 8;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string_view::npos ? std::string_view() : text.substr(first, last - first + 1);
}

void warnOfMaterials(const std::string& why, PolygonMesh& mesh) {
  if (mesh.warnings.size() < maxWarnings)
    mesh.warnings.push_back({"missing-materials", "Materials are ignored: " + why, 1});
}

// Paths of another computer, such as C:\\textures\\a.png, are reduced to the name of the file.
std::string_view nearName(std::string_view name, const std::string& from, const SourceFiles& files,
                          const std::string& where) {
  const auto found = resolveUri(name, from, files, where);
  return !found && found.error().code == ErrorCode::ExternalResource ? baseName(name) : name;
}

// The materials of an MTL file: colour, opacity and colour texture.
struct MtlReader {
  std::string from;  // path of the MTL file; image names are relative to it
  const SourceFiles& files;
  const std::string& where;
  PolygonMesh& mesh;
  std::map<std::string, int, std::less<>>& materialOf;
  std::map<std::string, int, std::less<>>& imageOf;  // image index by name; -1 if missing
  std::map<const std::uint8_t*, int>& imageAt;       // image index by bytes, because one file may have many names
  Material* current = nullptr;
  // Statements of the current material, which may come in any order.
  std::optional<double> opacity{}, transparency{};
  bool hasImage = false, hasCommas = false;
  int unclear = 0;  // materials that state Tr 1 without d

  void readImage(std::string_view text, Material& material) {
    std::string_view name = trimmed(text);
    while (name.starts_with('-')) {  // skips options such as -s 1 1 1 and -clamp on
      const std::string_view option = takeWord(name);
      double number;
      while (takeNumber(name, number)) {
      }
      name = trimmed(name);
      std::string_view rest = name;
      const std::string value = lowerCase(takeWord(rest));
      if ((value != "on" && value != "off") || trimmed(rest).empty()) continue;
      name = rest;
      if (lowerCase(option) == "-clamp" && value == "on") material.wrapS = material.wrapT = Material::Wrap::Clamp;
      name = trimmed(name);
    }
    const auto [known, isNew] = imageOf.try_emplace(std::string(name), -1);
    material.baseColorImage = known->second;
    if (!isNew) return;
    const auto found = resolveUri(nearName(name, from, files, where), from, files, where);
    const bool isFile = found && found->owned.empty();
    if (const auto same = isFile ? imageAt.find(found->bytes.data()) : imageAt.end(); same != imageAt.end()) {
      material.baseColorImage = known->second = same->second;
      return;
    }
    const std::string type = found ? imageType(found->bytes) : "";
    if (type.empty()) {
      if (mesh.warnings.size() < maxWarnings)
        mesh.warnings.push_back(
            {"missing-texture",
             "A texture is ignored: " +
                 (found ? inQuotes(name) + " is not in a supported image format." : found.error().message),
             1});
      return;
    }
    material.baseColorImage = known->second = static_cast<int>(mesh.scene.images.size());
    if (isFile) imageAt[found->bytes.data()] = known->second;
    mesh.scene.images.push_back({type, {found->bytes.begin(), found->bytes.end()}});
  }

  void readStatement(const std::string& word, std::string_view text) {
    double value;
    if (word == "kd") {
      hasCommas |= hasDecimalComma(text);
      for (int c = 0; c < 3 && takeNumber(text, value); ++c) current->baseColor[c] = linearColor(value);
    } else if (word == "d" || word == "tr") {
      std::string_view rest = text;
      if (lowerCase(takeWord(rest)) == "-halo") text = rest;
      if (takeNumber(text, value) && std::isfinite(value)) (word == "d" ? opacity : transparency) = value;
    } else if (word == "map_kd") {
      readImage(text, *current);
      hasImage = true;
    }
  }

  // `d` takes precedence over `Tr`. Some programs write Tr 1 for opaque materials.
  void finishMaterial() {
    if (!current) return;
    const bool isUnclear = !opacity && transparency && *transparency >= 1;
    unclear += isUnclear;
    const double alpha = isUnclear ? 1 : opacity.value_or(1 - transparency.value_or(0));
    auto& color = current->baseColor;
    if (alpha < 1) {
      current->alphaMode = Material::Alpha::Blend;
      color[3] = static_cast<float>(std::max(alpha, 0.0));
    }
    // Programs that show an image instead of the colour write black.
    if (hasImage && color[0] == 0 && color[1] == 0 && color[2] == 0) color = {1, 1, 1, color[3]};
    opacity = transparency = {};
    hasImage = false;
    current = nullptr;
  }

  void read(std::span<const std::uint8_t> bytes) {
    if (isUtf16(bytes)) return warnOfMaterials(std::string(baseName(from)) + utf16, mesh);
    LineReader lines(bytes);
    for (std::string_view line; lines.next(line);) {
      const std::string word = lowerCase(takeWord(line));
      if (word != "newmtl") {
        if (current) readStatement(word, line);
        continue;
      }
      finishMaterial();
      if (mesh.scene.materials.size() >= maxMaterials) continue;
      const std::string name = asUtf8(trimmed(line));
      materialOf[name] = static_cast<int>(mesh.scene.materials.size());
      current = &mesh.scene.materials.emplace_back();
      current->name = name;
    }
    finishMaterial();
    if (hasCommas) warnOfMaterials(decimalComma(std::string(baseName(from))).message, mesh);
    if (unclear > 0)
      mesh.warnings.push_back({"unclear-opacity",
                               std::string(baseName(from)) +
                                   ": Tr 1 without d is read as opaque, because some programs mean that. For an "
                                   "invisible material, write d 0.",
                               unclear});
  }
};

// Colour of a vertex without one: white.
const Vec3 noColor = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());

// Material name for polygons without one.
constexpr const char* unnamed = "default";

// A range of polygons with one name, up to the start of the next range.
struct NamedRun {
  int start;  // first polygon
  std::string name;
};

struct ObjReader {
  const NamedBytes& file;
  const SourceFiles& files;
  const std::vector<std::string>& wanted;  // names of the selected objects; empty for all
  const std::string& where;
  const FractionReport& onProgress;
  PolygonMesh mesh;
  std::vector<Vec3> colors, normals;
  std::vector<Coordinate> coordinates;
  std::vector<int> cornerNormal, cornerCoordinate;  // -1 if a corner has none
  std::map<std::string, int, std::less<>> materialOf, imageOf;
  std::map<const std::uint8_t*, int> imageAt;
  std::set<std::string, std::less<>> libraries;  // names of libraries already read
  std::set<const std::uint8_t*> librariesAt;
  std::vector<NamedRun> objects{}, groups{};
  std::vector<Vec3> paint{};  // colours of ZBrush, one per vertex
  std::int64_t line = 0;
  int leftOut = 0;

  Error malformed(const std::string& what) const {
    return {ErrorCode::MalformedFile, where + ", line " + grouped(line) + ": " + what + ". Export the file again."};
  }

  Status readVertex(std::string_view text) {
    double value[6];
    int count = 0;
    while (count < 6 && takeNumber(text, value[count])) ++count;
    if (hasDecimalComma(text)) return decimalComma(where + ", line " + grouped(line));
    if (count < 3) return malformed("a vertex needs three numbers");
    if (mesh.positions.size() >= maxElements)
      return Error{ErrorCode::TooLarge,
                   where + " has more than " + grouped(maxElements) + " vertices. Simplify the mesh first."};
    mesh.positions.emplace_back(value);
    if (count == 6) {
      colors.resize(mesh.positions.size() - 1, noColor);
      colors.emplace_back(value + 3);
    }
    return {};
  }

  // Reads a 1-based index, or a negative one relative to the end. The result is 0-based, or -1 for none.
  Status readIndex(std::string_view& text, std::size_t count, int& index) {
    std::int64_t number = 0;
    if (!takeInteger(text, number) || number == 0)
      return malformed("a face has an index that is not a whole number from 1");
    const std::int64_t place = number > 0 ? number - 1 : static_cast<std::int64_t>(count) + number;
    if (place < 0 || place > 0x7ffffffe)
      return Error{ErrorCode::IndexOutOfRange,
                   where + ", line " + grouped(line) + ": a face has the index " + grouped(number) +
                       ", which does not exist. Export the file again.",
                   -1, -1, mesh.polygonCount()};
    index = static_cast<int>(place);
    return {};
  }

  Status readCorner(std::string_view word) {
    int vertex = -1, coordinate = -1, normal = -1;
    if (Status read = readIndex(word, mesh.positions.size(), vertex); !read) return read;
    if (word.starts_with('/')) {
      word.remove_prefix(1);
      if (!word.empty() && word[0] != '/')
        if (Status read = readIndex(word, coordinates.size(), coordinate); !read) return read;
    }
    if (word.starts_with('/') && word.size() > 1) {
      word.remove_prefix(1);
      if (Status read = readIndex(word, normals.size(), normal); !read) return read;
    }
    if (!word.empty() && word != "/") return malformed("a face has a corner that is not v, v/vt, v//vn or v/vt/vn");
    mesh.corners.push_back(vertex);
    cornerCoordinate.push_back(coordinate);
    cornerNormal.push_back(normal);
    return {};
  }

  Status readFace(std::string_view text) {
    const std::size_t start = mesh.corners.size();
    for (std::string_view word = takeWord(text); !word.empty() && word[0] != '#'; word = takeWord(text))
      if (Status corner = readCorner(word); !corner) return corner;
    if (mesh.corners.size() > 0x7fffffff / 2)
      return Error{ErrorCode::TooLarge, where + " has too many faces. Simplify the mesh first."};
    if (mesh.corners.size() - start >= 3) {
      mesh.ends.push_back(static_cast<int>(mesh.corners.size()));
      return {};
    }
    ++leftOut;
    mesh.corners.resize(start);
    cornerCoordinate.resize(start);
    cornerNormal.resize(start);
    return {};
  }

  void useMaterial(std::string_view name) {
    const auto it = materialOf.find(name);
    const int material = it == materialOf.end() ? -1 : it->second;
    auto& groups = mesh.scene.groups;
    if (!groups.empty() && groups.back().start == mesh.polygonCount()) groups.pop_back();
    groups.push_back({mesh.polygonCount(), 0, material, material < 0 ? std::string(name) : ""});
  }

  void startRun(std::vector<NamedRun>& runs, std::string_view name) {
    if (!runs.empty() && runs.back().start == mesh.polygonCount()) runs.pop_back();
    if (runs.empty() && mesh.polygonCount() > 0) runs.push_back({0, unnamed});
    runs.push_back({mesh.polygonCount(), std::string(name.empty() ? std::string_view(unnamed) : name)});
  }

  // Groups serve as objects if the file has none. An object exists only if it has polygons.
  Status takeObjects() {
    const std::vector<NamedRun>& runs = objects.empty() ? groups : objects;
    for (const NamedRun& run : runs)
      if (run.start < mesh.polygonCount()) addObject(run.name, mesh.objects);
    keepObjects(runs);
    if (Status known = checkObjects(wanted, mesh.objects, where); !known) return known;
    if (wanted.empty()) return {};
    std::vector<char> taken(mesh.polygonCount(), 0);
    for (std::size_t r = 0; r < runs.size(); ++r)
      if (takesObject(wanted, runs[r].name))
        std::fill(taken.begin() + runs[r].start, r + 1 < runs.size() ? taken.begin() + runs[r + 1].start : taken.end(),
                  1);
    keepPolygons(taken);
    return {};
  }

  void keepObjects(const std::vector<NamedRun>& runs) {
    for (std::size_t r = 0; r < runs.size(); ++r) {
      ObjectFaces object{runs[r].name, runs[r].start, 0};
      object.count = (r + 1 < runs.size() ? runs[r + 1].start : mesh.polygonCount()) - object.start;
      if (runs[r].name != unnamed) object.nodeName = runs[r].name;
      object.isGroup = objects.empty();
      if (object.count > 0) mesh.scene.objects.push_back(std::move(object));
    }
  }

  // Removes polygons that are not selected, and vertices used only by them.
  void keepPolygons(const std::vector<char>& taken) {
    std::vector<int> vertexOf(mesh.positions.size(), -1), ends;
    std::vector<int> polygonsBefore(taken.size() + 1, 0);
    std::size_t kept = 0;
    for (int p = 0; p < mesh.polygonCount(); ++p) {
      polygonsBefore[p + 1] = polygonsBefore[p] + taken[p];
      if (!taken[p]) continue;
      for (int c = mesh.firstCorner(p); c < mesh.ends[p]; ++c, ++kept) {
        vertexOf[mesh.corners[c]] = 0;
        mesh.corners[kept] = mesh.corners[c];
        cornerNormal[kept] = cornerNormal[c];
        cornerCoordinate[kept] = cornerCoordinate[c];
      }
      ends.push_back(static_cast<int>(kept));
    }
    for (auto* corners : {&mesh.corners, &cornerNormal, &cornerCoordinate}) corners->resize(kept);
    mesh.ends = std::move(ends);
    for (MaterialGroup& group : mesh.scene.groups) group.start = polygonsBefore[group.start];
    for (ObjectFaces& object : mesh.scene.objects) {
      const int end = polygonsBefore[object.start + object.count];
      object.start = polygonsBefore[object.start];
      object.count = end - object.start;
    }
    std::erase_if(mesh.scene.objects, [](const ObjectFaces& object) { return object.count == 0; });
    keepVertices(vertexOf);
  }

  // `vertexOf` is -1 for removed vertices.
  void keepVertices(std::vector<int>& vertexOf) {
    int count = 0;
    for (std::size_t v = 0; v < vertexOf.size(); ++v) {
      if (vertexOf[v] < 0) continue;
      mesh.positions[count] = mesh.positions[v];
      if (!colors.empty()) colors[count] = colors[v];
      vertexOf[v] = count++;
    }
    mesh.positions.resize(count);
    if (!colors.empty()) colors.resize(count);
    for (int& corner : mesh.corners) corner = vertexOf[corner];
  }

  Result<Resource> find(std::string_view name) const {
    return resolveUri(nearName(name, file.name, files, where), file.name, files, where);
  }

  bool isFile(std::string_view name) const { return bool(find(name)); }

  // In "./a.mtl ./b.mtl", isFile alone would accept the whole text because of the last name, b.mtl.
  bool beginsWithLibrary(std::string_view text) const {
    std::string_view rest = text;
    for (std::string_view word = takeWord(rest); !rest.empty(); word = takeWord(rest))
      if (extensionOf(word) == "mtl") return isFile(text.substr(0, text.size() - rest.size()));
    return false;
  }

  // Reads one name, which may contain spaces, or several. A name ends where a given file matches, or at .mtl.
  void readLibraries(std::string_view text) {
    if (!beginsWithLibrary(text) && isFile(text)) return readLibrary(text);
    int words = 0;
    std::string_view name = text, rest = text;
    for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
      const std::string_view read = name.substr(0, name.size() - rest.size());
      const bool ends = rest.empty() || extensionOf(word) == "mtl" || (++words <= maxWords && isFile(read));
      if (!ends) continue;
      readLibrary(read);
      name = rest = trimmed(rest);
      words = 0;
    }
  }

  void readLibrary(std::string_view name) {
    if (libraries.size() >= maxLibraries || !libraries.emplace(name).second) return;
    const auto found = find(name);
    const std::string folder = file.name.substr(0, file.name.size() - baseName(file.name).size());
    if (found && !librariesAt.insert(found->bytes.data()).second) return;
    const std::string from = folder + std::string(nearName(name, file.name, files, where));
    if (found) return MtlReader{from, files, where, mesh, materialOf, imageOf, imageAt}.read(found->bytes);
    warnOfMaterials(found.error().message, mesh);
  }

  // Reads "# shapespline offset X Y Z" from an OBJ for a point cache (mesh_writer.h).
  void readComment(std::string_view text) {
    Vec3 offset;
    if (takeWord(text) != "shapespline" || takeWord(text) != "offset") return;
    if (takeNumber(text, offset[0]) && takeNumber(text, offset[1]) && takeNumber(text, offset[2]) && offset.allFinite())
      mesh.offset = offset;
  }

  // Reads the colours that ZBrush writes: 8 hexadecimal digits per vertex for mask, red, green and blue.
  void readPaint(std::string_view text) {
    for (text = trimmed(text); text.size() >= 8 && paint.size() < maxElements; text.remove_prefix(8)) {
      std::uint32_t number = 0;
      const std::string_view digits = text.substr(0, 8);
      const auto [end, error] = std::from_chars(digits.begin(), digits.end(), number, 16);
      if (error != std::errc() || end != digits.end()) return;
      paint.emplace_back(number >> 16 & 255, number >> 8 & 255, number & 255);
    }
  }

  Status readLine(std::string_view text) {
    const std::string word = lowerCase(takeWord(text));
    double value;
    if (word == "v") return readVertex(text);
    if (word == "f") return readFace(text);
    if (word == "#") readComment(text);
    if (word == "#mrgb") readPaint(text);
    if (word == "vt") {
      Coordinate coordinate{};
      for (int c = 0; c < 2 && takeNumber(text, value); ++c) coordinate[c] = static_cast<float>(value);
      if (hasDecimalComma(text)) return decimalComma(where + ", line " + grouped(line));
      coordinates.push_back(coordinate);
    } else if (word == "vn") {
      Vec3 normal = Vec3::Zero();
      for (int c = 0; c < 3 && takeNumber(text, value); ++c) normal[c] = value;
      if (hasDecimalComma(text)) return decimalComma(where + ", line " + grouped(line));
      normals.push_back(normal);
    } else if (word == "o" || word == "g") {
      startRun(word == "o" ? objects : groups, asUtf8(trimmed(text)));
    } else if (word == "usemtl") {
      useMaterial(asUtf8(trimmed(text)));
    } else if (word == "mtllib") {
      readLibraries(trimmed(text));
    } else if (word == "l" || word == "p" || word == "curv" || word == "curv2" || word == "surf") {
      ++leftOut;
    }
    return {};
  }

  Status readLines() {
    const FractionReport onLine = partOf(onProgress, 0, 0.9);
    LineReader lines(file.bytes);
    std::string joined;
    for (std::string_view text; lines.next(text);) {
      line = lines.lineNumber();
      reportLine(onLine, lines, file.bytes.size());
      const std::string_view line = trimmed(text);
      if (!joined.empty() && line.empty() && !lines.rest().empty()) continue;    // as in files with doubled line ends
      if (line.ends_with('\\') && !(joined.empty() && line.starts_with('#'))) {  // the line continues on the next one
        joined.append(line.substr(0, line.size() - 1)).push_back(' ');
        continue;
      }
      const Status read = readLine(joined.empty() ? text : std::string_view(joined.append(text)));
      if (!read) return read;
      joined.clear();
    }
    return readLine(joined);  // the last line may end with a backslash
  }

  // A vertex's normal is the mean of its corners' normals. Requires a normal at every corner.
  void keepNormals() {
    const auto known = [&](int n) { return n >= 0 && n < static_cast<int>(normals.size()) && normals[n].allFinite(); };
    if (cornerNormal.empty() || !std::all_of(cornerNormal.begin(), cornerNormal.end(), known)) return;
    mesh.normals.assign(mesh.positions.size(), Vec3::Zero());
    for (std::size_t c = 0; c < mesh.corners.size(); ++c) mesh.normals[mesh.corners[c]] += normals[cornerNormal[c]];
    for (Vec3& normal : mesh.normals) normal.normalize();
  }

  // Ignores coordinates that are missing or not numbers.
  void keepCoordinates() {
    const auto usable = [&](int t) {
      return t < static_cast<int>(coordinates.size()) && std::isfinite(coordinates[t][0]) &&
             std::isfinite(coordinates[t][1]);
    };
    int given = 0, broken = 0;
    for (int& t : cornerCoordinate) {
      if (t < 0) continue;
      ++given;
      if (!usable(t)) {
        ++broken;
        t = -1;
      }
    }
    if (broken > 0)
      mesh.warnings.push_back({"texture-coordinates",
                               where + ": some corners refer to texture coordinates that are missing or not "
                                       "finite. They are ignored.",
                               broken});
    if (given > broken) placeCoordinates(mesh, coordinates, cornerCoordinate);
  }

  void keepColors() {
    if (colors.empty()) return;
    const bool isPaint = !paint.empty();
    std::vector<float> numbers;
    for (const Vec3& color : colors)
      for (int c = 0; c < 4; ++c) numbers.push_back(c < 3 ? static_cast<float>(color[c]) : 1);
    setColors(mesh, std::move(numbers), isPaint ? ColorType::Byte : ColorType::Any, ColorType::Any);
  }

  void finishGroups() {
    auto& groups = mesh.scene.groups;
    for (MaterialGroup& group : groups) {  // a library may come after its use
      if (group.name.empty()) continue;
      if (const auto it = materialOf.find(group.name); it != materialOf.end()) {
        group.material = it->second;
        group.name.clear();
      }
    }
    if (groups.empty() || groups[0].start > 0) groups.insert(groups.begin(), {0, 0, -1});
    for (std::size_t g = 0; g < groups.size(); ++g)
      groups[g].count = (g + 1 < groups.size() ? groups[g + 1].start : mesh.polygonCount()) - groups[g].start;
  }

  Result<PolygonMesh> read() {
    if (Status lines = readLines(); !lines) return lines.error();
    if (Status polygons = checkPolygons(mesh, where); !polygons) return polygons.error();
    if (!colors.empty()) paint.clear();
    else colors = paint;
    if (!colors.empty()) colors.resize(mesh.positions.size(), noColor);
    if (Status taken = takeObjects(); !taken) return taken.error();
    reportFraction(onProgress, 0.92);
    keepNormals();
    reportFraction(onProgress, 0.95);
    keepCoordinates();
    keepColors();
    finishGroups();
    if (leftOut > 0)
      mesh.warnings.push_back({"skipped-primitives", where + ": lines, points and curves are ignored.", leftOut});
    return std::move(mesh);
  }
};

}  // namespace

Status checkPolygons(const PolygonMesh& mesh, const std::string& where) {
  if (mesh.ends.empty()) return Error{ErrorCode::NoTriangles, where + " has no faces. Export a mesh with faces."};
  const int n = static_cast<int>(mesh.positions.size());
  for (int p = 0; p < mesh.polygonCount(); ++p)
    for (int c = mesh.firstCorner(p); c < mesh.ends[p]; ++c)
      if (mesh.corners[c] < 0 || mesh.corners[c] >= n)
        return Error{ErrorCode::IndexOutOfRange,
                     where + ": face " + grouped(p) + " refers to vertex " + grouped(mesh.corners[c]) +
                         " (counted from 0), but there are " + grouped(n) + " vertices. Export the mesh again.",
                     -1, mesh.corners[c], p};
  return {};
}

Error decimalComma(const std::string& place) {
  return {ErrorCode::MalformedFile, place +
                                        ": a number has a decimal comma or is followed by a comma. Export the file "
                                        "with decimal points, and with spaces between the numbers."};
}

void warnOfLeftOut(PolygonMesh& mesh, int leftOut, const std::string& where) {
  if (leftOut > 0)
    mesh.warnings.push_back(
        {"skipped-primitives", where + ": faces with fewer than three corners are ignored.", leftOut});
}

Result<PolygonMesh> readObj(const NamedBytes& file, const SourceFiles& files, const std::vector<std::string>& objects,
                            const std::string& where, const FractionReport& onProgress) {
  return ObjReader{file, files, objects, where, onProgress, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}.read();
}

}  // namespace shapespline
