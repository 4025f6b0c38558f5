#include "io/numbered_files.h"

#include <charconv>
#include <string_view>

#include "io/base/byte_text.h"
#include "io/cache/point_cache.h"

namespace shapespline {

namespace {

struct Numbered {
  std::string_view path;  // before the number
  std::int64_t number = -1;
};

Numbered numberIn(std::string_view path) {
  const std::string_view stem = path.substr(0, path.rfind('.'));
  std::size_t start = stem.size();
  while (start > 0 && stem[start - 1] >= '0' && stem[start - 1] <= '9') --start;
  Numbered out{stem.substr(0, start)};
  const auto read = std::from_chars(stem.data() + start, stem.data() + stem.size(), out.number);
  if (read.ec != std::errc() || out.number > 1'000'000'000) out.number = -1;
  return out;
}

}  // namespace

std::optional<NumberedFiles> numberedFiles(const std::vector<MeshFile>& meshes) {
  const FileKind kind = meshes[0].kind;
  if (meshes.size() < 2 || (kind != FileKind::Obj && kind != FileKind::Ply)) return {};
  const Numbered first = numberIn(meshes[0].file->name);
  NumberedFiles out;
  std::int64_t last = -1;
  for (const MeshFile& mesh : meshes) {
    const Numbered at = numberIn(mesh.file->name);
    if (mesh.kind != kind || at.path != first.path || at.number <= last) return {};
    last = at.number;
    out.seconds.push_back(static_cast<double>(at.number - first.number) / kFramesPerSecond);
  }
  out.name = baseName(first.path);
  while (!out.name.empty() && (out.name.back() == '_' || out.name.back() == '-' || out.name.back() == '.'))
    out.name.pop_back();
  return out;
}

}  // namespace shapespline
