#include "io/file_kind.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "io/base/byte_text.h"
#include "io/cache/point_cache.h"
#include "io/gltf/glb_container.h"
#include "io/polygon/text_reader.h"

namespace shapespline {

namespace {

std::string_view textOf(std::span<const std::uint8_t> bytes) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  return start == std::string_view::npos ? std::string_view() : text.substr(start);
}

bool startsWithWord(std::string_view text, std::string_view lowerCase) {
  return text.size() >= lowerCase.size() &&
         std::equal(lowerCase.begin(), lowerCase.end(), text.begin(),
                    [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
}

// Common file formats that are not supported, with advice.
struct OtherFormat {
  std::string_view extension, what, advice;
};

constexpr std::string_view asMesh = "Export it as glTF, OBJ or PLY.";
constexpr std::string_view unpack = "Unpack it and use the files inside.";
constexpr std::string_view asFrames = "Export its frames as numbered OBJ files, or as an OBJ with a PC2 or MDD file.";
constexpr std::string_view asGltf = "Export it as glTF.";
constexpr std::string_view noFaces =
    "It has points without faces. Make a mesh from it and export the mesh as glTF, OBJ or PLY.";

constexpr OtherFormat otherFormats[] = {
    {"fbx", "an FBX file", asGltf},
    {"blend", "a Blender file", asGltf},
    {"abc", "an Alembic file", asFrames},
    {"usd", "a USD file", "Export it as glTF, or its frames as numbered OBJ files."},
    {"stl", "an STL file", "It does not state which triangles share a vertex. Export the shape as glTF, OBJ or PLY."},
    {"dae", "a COLLADA file", asGltf},
    {"x3d", "an X3D file", asGltf},
    {"wrl", "a VRML file", asGltf},
    {"3ds", "a 3DS file", asGltf},
    {"3mf", "a 3MF file", asMesh},
    {"max", "a 3ds Max file", asGltf},
    {"ma", "a Maya file", asGltf},
    {"c4d", "a Cinema 4D file", asGltf},
    {"lwo", "a LightWave file", asMesh},
    {"hip", "a Houdini file", asGltf},
    {"bgeo", "a Houdini geometry file", asMesh},
    {"ztl", "a ZBrush file", asMesh},
    {"skp", "a SketchUp file", asGltf},
    {"vrm", "a VRM avatar", "Rename it to .glb."},
    {"bvh", "a skeleton's motion without a mesh", "Export the mesh with its animation as glTF."},
    {"step", "a CAD file", asMesh},
    {"iges", "a CAD file", asMesh},
    {"dxf", "a CAD file", asMesh},
    {"vtk", "a VTK file", asMesh},
    {"pcd", "a point cloud", noFaces},
    {"las", "a point cloud", noFaces},
    {"e57", "a point cloud", noFaces},
    {"xyz", "a point cloud", noFaces},
    {"xml", "an XML file", asGltf},
    {"zip", "a ZIP archive", unpack},
    {"gz", "a gzip archive", unpack},
    {"7z", "a 7-Zip archive", unpack},
    {"rar", "a RAR archive", unpack},
    {"tar", "a tar archive", unpack},
};

// Maps alternative extensions of a format to its main extension.
std::string_view mainExtension(std::string_view extension) {
  static constexpr std::pair<std::string_view, std::string_view> same[] = {
      {"usda", "usd"},  {"usdc", "usd"},  {"usdz", "usd"},     {"mb", "ma"},   {"stp", "step"}, {"igs", "iges"},
      {"x3dv", "x3d"},  {"x3db", "x3d"},  {"laz", "las"},      {"pts", "xyz"}, {"vtp", "vtk"},  {"vtu", "vtk"},
      {"hiplc", "hip"}, {"hipnc", "hip"}, {"blend1", "blend"}, {"tgz", "gz"}};
  for (const auto& [other, main] : same)
    if (other == extension) return main;
  return extension;
}

// The extension that matches the content; empty if unknown.
std::string_view extensionByContent(std::string_view text) {
  static constexpr std::pair<std::string_view, std::string_view> starts[] = {
      {"kaydara fbx", "fbx"}, {"; fbx ", "fbx"},     {"blender", "blend"},      {"ogawa", "abc"},
      {"#usda ", "usd"},      {"pxr-usdc", "usd"},   {"solid ", "stl"},         {"//maya ascii", "ma"},
      {"<?xml", "xml"},       {"pk\x03\x04", "zip"}, {"\x1f\x8b", "gz"},        {"7z\xbc\xaf\x27\x1c", "7z"},
      {"rar!", "rar"},        {"#vrml ", "wrl"},     {"# vtk datafile", "vtk"}, {"iso-10303-21", "step"},
      {"hierarchy", "bvh"}};
  for (const auto& [start, extension] : starts)
    if (startsWithWord(text, start)) return extension;
  return {};
}

const OtherFormat* otherFormat(std::string_view extension) {
  for (const OtherFormat& format : otherFormats)
    if (format.extension == extension) return &format;
  return nullptr;
}

// Describes an unsupported file, with advice. For archives and XML, the extension decides if it is known.
std::string somethingElse(std::string_view text, std::string_view extension) {
  if (startsWithWord(text, "<!doctype html") || startsWithWord(text, "<html") || startsWithWord(text, "<head"))
    return " is a web page (HTML), not a 3D file. Download the file itself (on GitHub, the raw file).";
  if (text.starts_with("version https://git-lfs"))
    return " is a Git LFS pointer, not the file itself. Fetch it with git lfs pull.";
  const OtherFormat* named = otherFormat(mainExtension(extension));
  const OtherFormat* found = otherFormat(extensionByContent(text));
  const bool isContainer = found && (found->advice == unpack || found->extension == "xml");
  const OtherFormat* format = found && !(isContainer && named) ? found : named;
  if (!format) return {};
  std::string sentence = " is ";
  sentence.append(format->what).append(format->advice == unpack ? ". " : ", which is not supported. ");
  return sentence.append(format->advice);
}

// Whether the first lines have only keywords of OBJ, and a vertex.
bool isObj(std::string_view text) {
  static constexpr std::array keywords{"v",      "vt",  "vn",   "vp",    "f",      "l",      "p",
                                       "o",      "g",   "s",    "mg",    "mtllib", "usemtl", "usemap",
                                       "cstype", "deg", "curv", "curv2", "surf",   "parm",   "end"};
  constexpr std::size_t looked = 1 << 16;
  const bool isCut = text.size() > looked;
  text = text.substr(0, looked);
  LineReader lines({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  bool hasVertex = false, continues = false;
  for (std::string_view line; lines.next(line) && !(isCut && lines.rest().empty());) {
    const bool isContinued = std::exchange(continues, line.ends_with('\\'));
    const std::string word = lowerCase(takeWord(line));
    if (isContinued || word.empty() || word.starts_with('#')) continue;
    if (std::find(keywords.begin(), keywords.end(), word) == keywords.end()) return false;
    hasVertex |= word == "v";
  }
  return hasVertex;
}

bool isOff(std::string_view text) {
  const std::string_view word = takeWord(text);
  if (!word.ends_with("OFF") || word.find_first_not_of("STCN4nOFF") != std::string_view::npos) return false;
  const std::string_view next = takeWord(text);
  return next.empty() || next.starts_with('#') || next == "BINARY" || (next[0] >= '0' && next[0] <= '9');
}

// `named`: the name is that of a glTF file. Other JSON is glTF only if it says so.
std::optional<FileKind> kindByContent(std::span<const std::uint8_t> bytes, std::string_view text, bool named) {
  if (isPc2(bytes)) return FileKind::Pc2;
  if (isGlb(bytes)) return FileKind::Gltf;
  if (text.starts_with('{') && (named || text.find("\"asset\"") != std::string_view::npos)) return FileKind::Gltf;
  std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  if (isOff(line)) return FileKind::Off;
  if (takeWord(line) == "ply" && takeWord(line).empty() && text.size() > 3) return FileKind::Ply;
  if (isObj(text)) return FileKind::Obj;
  return std::nullopt;
}

bool isGltfName(std::string_view extension) { return extension == "glb" || extension == "gltf"; }

}  // namespace

bool isCompanion(const NamedBytes& file) {
  static constexpr std::array extensions{"bin", "png", "jpg", "jpeg", "webp", "ktx", "ktx2", "basis", "dds",     "gif",
                                         "bmp", "tga", "tif", "tiff", "hdr",  "mtl", "txt",  "md",    "ds_store"};
  const std::string extension = extensionOf(file.name);
  if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end()) return false;
  // A mesh may have got another extension: walk.glb.txt.
  if (isMeshName(std::string_view(file.name).substr(0, file.name.size() - extension.size() - 1))) return false;
  return extension != "txt" || !kindByContent(file.bytes, textOf(file.bytes), false);
}

std::string otherExtension(std::string_view name, FileKind kind) {
  static constexpr std::pair<std::string_view, std::string_view> formats[] = {
      {"glTF", "glb"}, {"OBJ", "obj"}, {"PLY", "ply"}, {"OFF", "off"}, {"PC2", "pc2"}, {"MDD", "mdd"}};
  const auto& [format, usual] = formats[static_cast<int>(kind)];
  const std::string extension = extensionOf(name);
  const bool fits = extension == usual || (kind == FileKind::Gltf && isGltfName(extension));
  if (fits || !(extension == "txt" || isMeshName(name))) return "";
  return std::string(" is read as ").append(format).append(", although its name ends in .").append(extension) +
         ". Rename it to end in ." + std::string(usual) + ".";
}

bool isMeshName(std::string_view name) {
  static constexpr std::array extensions{"glb", "gltf", "obj", "ply", "off", "pc2", "mdd"};
  const std::string extension = extensionOf(name);
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

Result<FileKind> fileKind(const NamedBytes& file, const std::string& where) {
  if (file.bytes.empty()) return Error{ErrorCode::EmptyFile, where + " is empty. Export or copy it again."};
  if (isUtf16(file.bytes)) return Error{ErrorCode::NotRecognised, where + utf16};
  const std::string extension = extensionOf(file.name);
  const std::string_view text = textOf(file.bytes);
  if (const auto kind = kindByContent(file.bytes, text, isGltfName(extension))) return *kind;
  if (const std::string what = somethingElse(text, extension); !what.empty())
    return Error{ErrorCode::NotRecognised, where + what};
  if (extension == "obj") return FileKind::Obj;
  if (extension == "mdd") return FileKind::Mdd;
  if (extension == "off" && text.starts_with('#')) return FileKind::Off;
  if (isMeshName(file.name))
    return Error{ErrorCode::NotRecognised,
                 where + " has the extension ." + extension + " but different content. Export it again."};
  return Error{ErrorCode::NotRecognised,
               where + " is not a supported 3D file. Give glTF (.glb, .gltf), OBJ, PLY or OFF files."};
}

}  // namespace shapespline
