#include "io/file_kind.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "io/base/byte_text.h"
#include "io/cache/point_cache.h"
#include "io/gltf/glb_container.h"

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

constexpr std::string_view kAsMesh = "Export it as glTF, OBJ or PLY.";
constexpr std::string_view kUnpack = "Unpack it and give the files in it.";
constexpr std::string_view kAsFrames = "Export its frames as numbered OBJ files, or as an OBJ with a PC2 or MDD file.";
constexpr std::string_view kAsGltf = "Export it as glTF.";
constexpr std::string_view kNoFaces =
    "It holds points without faces: make a mesh of it and export that as glTF, OBJ or PLY.";

constexpr OtherFormat kOtherFormats[] = {
    {"fbx", "an FBX file", kAsGltf},
    {"blend", "a Blender file", kAsGltf},
    {"abc", "an Alembic file", kAsFrames},
    {"usd", "a USD file", "Export it as glTF, or its frames as numbered OBJ files."},
    {"stl", "an STL file", "It does not state which triangles share a vertex: export the shape as glTF, OBJ or PLY."},
    {"dae", "a COLLADA file", kAsGltf},
    {"x3d", "an X3D file", kAsGltf},
    {"wrl", "a VRML file", kAsGltf},
    {"3ds", "a 3DS file", kAsGltf},
    {"3mf", "a 3MF file", kAsMesh},
    {"max", "a 3ds Max file", kAsGltf},
    {"ma", "a Maya file", kAsGltf},
    {"c4d", "a Cinema 4D file", kAsGltf},
    {"lwo", "a LightWave file", kAsMesh},
    {"hip", "a Houdini file", kAsGltf},
    {"bgeo", "a Houdini geometry file", kAsMesh},
    {"ztl", "a ZBrush file", kAsMesh},
    {"skp", "a SketchUp file", kAsGltf},
    {"vrm", "a VRM avatar", "Rename it to .glb."},
    {"bvh", "a skeleton's motion without a mesh", "Export the mesh with its animation as glTF."},
    {"step", "a CAD file", kAsMesh},
    {"iges", "a CAD file", kAsMesh},
    {"dxf", "a CAD file", kAsMesh},
    {"vtk", "a VTK file", kAsMesh},
    {"pcd", "a point cloud", kNoFaces},
    {"las", "a point cloud", kNoFaces},
    {"e57", "a point cloud", kNoFaces},
    {"xyz", "a point cloud", kNoFaces},
    {"xml", "an XML file", kAsGltf},
    {"zip", "a ZIP archive", kUnpack},
    {"gz", "a gzip archive", kUnpack},
    {"7z", "a 7-Zip archive", kUnpack},
    {"rar", "a RAR archive", kUnpack},
    {"tar", "a tar archive", kUnpack},
};

// Other endings of the same kinds.
std::string_view mainExtension(std::string_view extension) {
  static constexpr std::pair<std::string_view, std::string_view> kSame[] = {
      {"usda", "usd"},  {"usdc", "usd"},  {"usdz", "usd"},     {"mb", "ma"},   {"stp", "step"}, {"igs", "iges"},
      {"x3dv", "x3d"},  {"x3db", "x3d"},  {"laz", "las"},      {"pts", "xyz"}, {"vtp", "vtk"},  {"vtu", "vtk"},
      {"hiplc", "hip"}, {"hipnc", "hip"}, {"blend1", "blend"}, {"tgz", "gz"}};
  for (const auto& [other, main] : kSame)
    if (other == extension) return main;
  return extension;
}

// The extension that matches the content; empty if unknown.
std::string_view extensionByContent(std::string_view text) {
  static constexpr std::pair<std::string_view, std::string_view> kStarts[] = {
      {"kaydara fbx", "fbx"}, {"; fbx ", "fbx"},     {"blender", "blend"},      {"ogawa", "abc"},
      {"#usda ", "usd"},      {"pxr-usdc", "usd"},   {"solid ", "stl"},         {"//maya ascii", "ma"},
      {"<?xml", "xml"},       {"pk\x03\x04", "zip"}, {"\x1f\x8b", "gz"},        {"7z\xbc\xaf\x27\x1c", "7z"},
      {"rar!", "rar"},        {"#vrml ", "wrl"},     {"# vtk datafile", "vtk"}, {"iso-10303-21", "step"},
      {"hierarchy", "bvh"}};
  for (const auto& [start, extension] : kStarts)
    if (startsWithWord(text, start)) return extension;
  return {};
}

const OtherFormat* otherFormat(std::string_view extension) {
  for (const OtherFormat& format : kOtherFormats)
    if (format.extension == extension) return &format;
  return nullptr;
}

// Describes an unsupported file, with advice. For archives and XML, the extension decides if it is known.
std::string somethingElse(std::string_view text, std::string_view extension) {
  if (startsWithWord(text, "<!doctype html") || startsWithWord(text, "<html") || startsWithWord(text, "<head"))
    return " is a web page (HTML), not a 3D file. Download the file itself: on GitHub, its raw version.";
  if (text.starts_with("version https://git-lfs"))
    return " is a Git LFS pointer, not the file itself. Fetch it with git lfs pull.";
  const OtherFormat* named = otherFormat(mainExtension(extension));
  const OtherFormat* found = otherFormat(extensionByContent(text));
  const bool isContainer = found && (found->advice == kUnpack || found->extension == "xml");
  const OtherFormat* format = found && !(isContainer && named) ? found : named;
  if (!format) return {};
  std::string sentence = " is ";
  sentence.append(format->what).append(format->advice == kUnpack ? ". " : ", which is not supported. ");
  return sentence.append(format->advice);
}

std::optional<FileKind> kindByContent(std::span<const std::uint8_t> bytes, std::string_view text) {
  if (isPc2(bytes)) return FileKind::Pc2;
  if (isGlb(bytes) || text.starts_with('{')) return FileKind::Gltf;
  if (text.starts_with("ply\n") || text.starts_with("ply\r")) return FileKind::Ply;
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r\n"));
  if (word.size() <= 6 && word.ends_with("OFF")) return FileKind::Off;
  return std::nullopt;
}

}  // namespace

bool isCompanion(std::string_view name) {
  static constexpr std::array kExtensions{"bin", "png", "jpg", "jpeg", "webp", "ktx", "ktx2", "basis", "dds",     "gif",
                                          "bmp", "tga", "tif", "tiff", "hdr",  "mtl", "txt",  "md",    "ds_store"};
  const std::string extension = extensionOf(name);
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

bool isMeshName(std::string_view name) {
  static constexpr std::array kExtensions{"glb", "gltf", "obj", "ply", "off", "pc2", "mdd"};
  const std::string extension = extensionOf(name);
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

Result<FileKind> fileKind(const NamedBytes& file, const std::string& where) {
  if (file.bytes.empty()) return Error{ErrorCode::EmptyFile, where + " is empty. Export or copy it again."};
  if (isUtf16(file.bytes)) return Error{ErrorCode::NotRecognised, where + kUtf16};
  const std::string extension = extensionOf(file.name);
  const std::string_view text = textOf(file.bytes);
  if (const auto kind = kindByContent(file.bytes, text)) return *kind;
  if (const std::string what = somethingElse(text, extension); !what.empty())
    return Error{ErrorCode::NotRecognised, where + what};
  if (extension == "obj") return FileKind::Obj;
  if (extension == "mdd") return FileKind::Mdd;
  if (extension == "off" && text.starts_with('#')) return FileKind::Off;
  if (isMeshName(file.name))
    return Error{ErrorCode::NotRecognised,
                 where + " is named ." + extension + " but has different content. Export it again."};
  return Error{ErrorCode::NotRecognised,
               where + " is not a supported 3D file. Give glTF (.glb, .gltf), OBJ, PLY or OFF files."};
}

}  // namespace shapespline
