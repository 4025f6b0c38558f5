#include "io/numbered_files.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <string_view>

#include "core/base/format.h"
#include "io/base/byte_text.h"
#include "io/cache/point_cache.h"

namespace shapespline {

namespace {

using Sequence = std::pair<std::string_view, std::string>;

struct Numbered {
  std::string_view path;  // the text before the number and its sign
  std::string extension;
  std::optional<double> number;

  Sequence sequence() const { return {path, extension}; }
};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::string_view withoutDigits(std::string_view path) {
  while (!path.empty() && isDigit(path.back())) path.remove_suffix(1);
  return path;
}

std::string_view stemOf(std::string_view path) { return path.substr(0, path.rfind('.')); }

Numbered numberedFrom(std::string_view path, std::string_view start) {
  constexpr std::size_t mostDigits = 24;
  const std::string digits(stemOf(path).substr(start.size()));
  Numbered out{start, extensionOf(path), {}};
  const double number = digits.empty() || digits.size() > mostDigits ? -1 : std::strtod(digits.c_str(), nullptr);
  if (number >= 0 && number <= 1e9) out.number = number;
  return out;
}

// A hyphen or plus before the number is its sign after a dot, after an underscore or at the start. Elsewhere the
// character separates name and number, unless another file has the same name and an unsigned number: walk-1, walk0.
void readSign(Numbered& file, const std::set<Sequence>& unsignedOnes) {
  if (!file.number || !(file.path.ends_with('-') || file.path.ends_with('+'))) return;
  const std::string_view before = file.path.substr(0, file.path.size() - 1);
  const char last = before.empty() ? '/' : before.back();
  const bool isSign = std::string_view("/\\._").find(last) != std::string_view::npos ||
                      (!isDigit(last) && unsignedOnes.contains({before, file.extension}));
  if (!isSign) return;
  if (file.path.ends_with('-')) file.number = -*file.number;
  file.path = before;
}

// Fractional frames: sim.1.25 between sim.1 and sim.2 is frame 1.25, not frame 25 of a sequence sim.1.
void readFraction(Numbered& file, std::string_view name, const std::set<Sequence>& unsignedOnes,
                  const std::set<Sequence>& whole) {
  if (!file.number || !file.path.ends_with('.')) return;
  const std::string_view before = file.path.substr(0, file.path.size() - 1), start = withoutDigits(before);
  if (start.size() == before.size()) return;
  Numbered fraction = numberedFrom(name, start);
  readSign(fraction, unsignedOnes);
  if (fraction.number && whole.contains(fraction.sequence())) file = fraction;
}

std::set<Sequence> sequencesOf(const std::vector<Numbered>& files) {
  std::set<Sequence> out;
  for (const Numbered& file : files)
    if (file.number) out.insert(file.sequence());
  return out;
}

std::vector<Numbered> numbersIn(const std::vector<MeshFile>& meshes) {
  std::vector<Numbered> files;
  for (const MeshFile& mesh : meshes)
    files.push_back(numberedFrom(mesh.file->name, withoutDigits(stemOf(mesh.file->name))));
  const std::set<Sequence> unsignedOnes = sequencesOf(files);
  for (Numbered& file : files) readSign(file, unsignedOnes);
  const std::set<Sequence> whole = sequencesOf(files);
  for (std::size_t i = 0; i < files.size(); ++i) readFraction(files[i], meshes[i].file->name, unsignedOnes, whole);
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
    out.seconds.push_back((*at.number - *files[0].number) / framesPerSecond);
  }
  out.name = nameOf(files[0].path);
  return out;
}

std::string sequencesAmong(const std::vector<MeshFile>& meshes) {
  const std::vector<Numbered> files = numbersIn(meshes);
  std::map<Sequence, int> counts;
  for (const Numbered& file : files)
    if (file.number) ++counts[file.sequence()];
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
