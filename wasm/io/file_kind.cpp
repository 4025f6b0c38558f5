#include "io/file_kind.h"

#include <algorithm>
#include <array>
#include <optional>

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

// A file that is something else: what it is and what to do.
const char* somethingElse(std::string_view text, const std::string& extension) {
  if (startsWithWord(text, "<!doctype html") || startsWithWord(text, "<html") || startsWithWord(text, "<head"))
    return " is a web page (HTML), not a 3D file. Download the file itself: on GitHub, its raw version.";
  if (text.starts_with("version https://git-lfs"))
    return " is a Git LFS pointer, not the file itself. Fetch it with git lfs pull.";
  if (text.starts_with("PK\x03\x04")) return " is a ZIP archive. Unpack it and give the files in it.";
  if (text.starts_with("\x1f\x8b")) return " is a gzip archive. Unpack it and give the file in it.";
  if (text.starts_with("Kaydara FBX") || extension == "fbx")
    return " is an FBX file, which is not supported. Export it as glTF.";
  if (text.starts_with("BLENDER") || extension == "blend")
    return " is a Blender file, which is not supported. Export it as glTF.";
  if (startsWithWord(text, "solid ") || extension == "stl")
    return " is an STL file, which is not supported: it does not say which triangles share a vertex. Export it as "
           "glTF, OBJ or PLY.";
  if (startsWithWord(text, "<?xml") || extension == "dae")
    return " is an XML file, which is not supported. Export it as glTF.";
  return nullptr;
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

Result<FileKind> fileKind(const NamedBytes& file, const std::string& where) {
  if (file.bytes.empty()) return Error{ErrorCode::EmptyFile, where + " is empty. Export or copy it again."};
  const std::string extension = extensionOf(file.name);
  const std::string_view text = textOf(file.bytes);
  if (const auto kind = kindByContent(file.bytes, text)) return *kind;
  if (const char* what = somethingElse(text, extension)) return Error{ErrorCode::NotRecognised, where + what};
  if (extension == "obj") return FileKind::Obj;
  if (extension == "mdd") return FileKind::Mdd;
  if (extension == "off" && text.starts_with('#')) return FileKind::Off;
  if (extension == "glb" || extension == "gltf" || extension == "ply" || extension == "off" || extension == "pc2")
    return Error{ErrorCode::NotRecognised,
                 where + " is named ." + extension + " but is not such a file. Export it again."};
  return Error{ErrorCode::NotRecognised,
               where + " is not a supported 3D file. Give glTF (.glb, .gltf), OBJ, PLY or OFF files."};
}

}  // namespace shapespline
