#include "io/numbered_files.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <string_view>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/cache/point_cache.h"

namespace shapespline {

namespace {

struct Numbered {
  std::string_view path;  // before the number and its sign
  std::string extension;
  std::optional<std::int64_t> number;
};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

Numbered numberIn(std::string_view path) {
  const std::string_view stem = path.substr(0, path.rfind('.'));
  std::size_t start = stem.size();
  while (start > 0 && isDigit(stem[start - 1])) --start;
  Numbered out{stem.substr(0, start), extensionOf(path), {}};
  std::int64_t number = -1;
  const auto read = std::from_chars(stem.data() + start, stem.data() + stem.size(), number);
  if (read.ec == std::errc() && number >= 0 && number <= 1'000'000'000) out.number = number;
  return out;
}

// A hyphen before the number is a sign behind a dot, an underscore or nothing. Behind anything else it only parts the
// number from the name, unless another file has the same name and a number without a hyphen: walk-1, walk0.
void readSigns(std::vector<Numbered>& files) {
  std::set<std::pair<std::string_view, std::string_view>> unsignedPaths;
  for (const Numbered& file : files)
    if (file.number) unsignedPaths.insert({file.path, file.extension});
  for (Numbered& file : files) {
    if (!file.number || !file.path.ends_with('-')) continue;
    const std::string_view before = file.path.substr(0, file.path.size() - 1);
    const char last = before.empty() ? '/' : before.back();
    const bool isSign = std::string_view("/\\._").find(last) != std::string_view::npos ||
                        (!isDigit(last) && unsignedPaths.contains({before, file.extension}));
    if (isSign) file.path = before, file.number = -*file.number;
  }
}

std::vector<Numbered> numbersIn(const std::vector<MeshFile>& meshes) {
  std::vector<Numbered> files;
  for (const MeshFile& mesh : meshes) files.push_back(numberIn(mesh.file->name));
  readSigns(files);
  return files;
}

std::string nameOf(std::string_view path) {
  std::string name(baseName(path));
  while (!name.empty() && (name.back() == '_' || name.back() == '-' || name.back() == '.')) name.pop_back();
  return name;
}

}  // namespace

std::optional<NumberedFiles> numberedFiles(const std::vector<MeshFile>& meshes) {
  const FileKind kind = meshes[0].kind;
  if (meshes.size() < 2 || (kind != FileKind::Obj && kind != FileKind::Ply)) return {};
  const std::vector<Numbered> files = numbersIn(meshes);
  NumberedFiles out;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Numbered& at = files[i];
    if (meshes[i].kind != kind || !at.number || at.path != files[0].path) return {};
    if (i > 0 && *at.number <= *files[i - 1].number) return {};
    out.seconds.push_back(static_cast<double>(*at.number - *files[0].number) / kFramesPerSecond);
  }
  out.name = nameOf(files[0].path);
  return out;
}

std::string sequencesAmong(const std::vector<MeshFile>& meshes) {
  const std::vector<Numbered> files = numbersIn(meshes);
  std::map<std::pair<std::string_view, std::string_view>, int> counts;
  for (const Numbered& file : files)
    if (file.number) ++counts[{file.path, file.extension}];
  std::erase_if(counts, [](const auto& entry) { return entry.second < 2; });
  if (counts.size() < 2) return {};
  std::string list;
  std::size_t listed = 0;
  for (const auto& [sequence, count] : counts) {
    if (++listed > 5) return list + ", and more";
    list += (list.empty() ? "" : ", ") + inQuotes(nameOf(sequence.first)) + " (" + grouped(count) + " files)";
  }
  return list;
}

}  // namespace shapespline
