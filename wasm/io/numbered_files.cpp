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

// The text before a number and its sign, and the text after it, with the extension in lower case.
using Sequence = std::pair<std::string_view, std::string>;

struct Numbered {
  Sequence sequence;
  double number = 0;
};

// A number's place in a path.
struct Digits {
  std::size_t from, to;
};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::string_view stemOf(std::string_view path) {
  const std::size_t folder = path.size() - baseName(path).size(), dot = path.rfind('.');
  return dot != std::string_view::npos && dot >= folder ? path.substr(0, dot) : path;
}

// The numbers in a file's name, from the end.
std::vector<Digits> digitsIn(std::string_view path) {
  constexpr std::size_t maxNumbers = 8;
  const std::string_view stem = stemOf(path);
  const std::size_t folder = path.size() - baseName(path).size();
  std::vector<Digits> out;
  for (std::size_t to = stem.size(); to > folder && out.size() < maxNumbers; --to) {
    if (!isDigit(stem[to - 1])) continue;
    std::size_t from = to;
    while (from > folder && isDigit(stem[from - 1])) --from;
    out.push_back({from, to});
    to = from + 1;
  }
  return out;
}

std::optional<Numbered> numberAt(std::string_view path, const Digits& at) {
  const double number = std::strtod(std::string(path.substr(at.from, at.to - at.from)).c_str(), nullptr);
  if (!(number <= 1e9)) return {};
  return Numbered{{path.substr(0, at.from), std::string(stemOf(path).substr(at.to)) + '.' + extensionOf(path)}, number};
}

// A hyphen or plus before the number is its sign after a dot, after an underscore or at the start. Elsewhere the
// character separates name and number, unless another file has the same name and an unsigned number: walk-1, walk0.
Numbered withSign(Numbered file, const std::set<Sequence>& unsignedOnes) {
  std::string_view& start = file.sequence.first;
  if (!(start.ends_with('-') || start.ends_with('+'))) return file;
  const std::string_view before = start.substr(0, start.size() - 1);
  const char last = before.empty() ? '/' : before.back();
  const bool isSign = std::string_view("/\\._").find(last) != std::string_view::npos ||
                      (!isDigit(last) && unsignedOnes.contains({before, file.sequence.second}));
  if (!isSign) return file;
  if (start.ends_with('-')) file.number = -file.number;
  start = before;
  return file;
}

// The number of files of each sequence, if every number in every name could be the frame.
struct Names {
  std::set<Sequence> unsignedOnes;
  std::map<Sequence, int> counts;

  explicit Names(const std::vector<MeshFile>& meshes) {
    std::vector<Numbered> all;
    for (const MeshFile& mesh : meshes)
      for (const Digits& at : digitsIn(mesh.file->name))
        if (auto read = numberAt(mesh.file->name, at)) all.push_back(std::move(*read));
    for (const Numbered& one : all) unsignedOnes.insert(one.sequence);
    for (const Numbered& one : all) ++counts[withSign(one, unsignedOnes).sequence];
  }

  // The frame of a file: the number in which most names differ, or the last one.
  std::optional<Numbered> frameOf(std::string_view path) const {
    const std::vector<Digits> digits = digitsIn(path);
    // Fractional frames: sim.1.25 between sim.1 and sim.2 is frame 1.25, not frame 25 of a sequence sim.1.
    for (std::size_t i = 0; i + 1 < digits.size(); ++i) {
      if (digits[i + 1].to + 1 != digits[i].from || path[digits[i + 1].to] != '.') continue;
      const auto read = numberAt(path, {digits[i + 1].from, digits[i].to});
      if (!read) continue;
      const Numbered fraction = withSign(*read, unsignedOnes);
      if (counts.contains(fraction.sequence)) return fraction;
    }
    std::optional<Numbered> best;
    int most = 0;
    for (const Digits& at : digits) {
      const auto read = numberAt(path, at);
      if (!read) continue;
      const Numbered one = withSign(*read, unsignedOnes);
      if (const int count = counts.at(one.sequence); count > most) {
        best = one;
        most = count;
      }
    }
    return best;
  }
};

std::vector<std::optional<Numbered>> framesOf(const std::vector<MeshFile>& meshes) {
  const Names names(meshes);
  std::vector<std::optional<Numbered>> out;
  for (const MeshFile& mesh : meshes) out.push_back(names.frameOf(mesh.file->name));
  return out;
}

// The parts of the name around the number: "walk" for "walk (", ").obj", and "walk_LOD0" for "walk_", "_LOD0.obj".
std::string nameOf(const Sequence& sequence) {
  constexpr std::string_view separators = " _-.()[]";
  std::string name(baseName(sequence.first));
  name.erase(name.find_last_not_of(separators) + 1);
  const std::string_view after = stemOf(sequence.second);
  name += after.substr(std::min(after.find_first_not_of(")] "), after.size()));
  name.erase(0, std::min(name.find_first_not_of(separators), name.size()));
  return name;
}

}  // namespace

std::optional<NumberedFiles> numberedFiles(const std::vector<MeshFile>& meshes) {
  const FileKind kind = meshes[0].kind;
  if (meshes.size() < 2 || (kind != FileKind::Obj && kind != FileKind::Ply)) return {};
  const std::vector<std::optional<Numbered>> files = framesOf(meshes);
  std::map<double, MeshFile> byNumber;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (meshes[i].kind != kind || !files[i] || files[i]->sequence != files[0]->sequence) return {};
    if (!byNumber.emplace(files[i]->number, meshes[i]).second) return {};
  }
  NumberedFiles out{nameOf(files[0]->sequence), {}, {}};
  for (const auto& [number, mesh] : byNumber) {
    out.meshes.push_back(mesh);
    out.seconds.push_back((number - byNumber.begin()->first) / framesPerSecond);
  }
  return out;
}

std::string sequencesAmong(const std::vector<MeshFile>& meshes) {
  std::map<Sequence, int> counts;
  for (const auto& file : framesOf(meshes))
    if (file) ++counts[file->sequence];
  std::erase_if(counts, [](const auto& entry) { return entry.second < 2; });
  if (counts.size() < 2) return {};
  std::string list;
  std::size_t listed = 0;
  for (const auto& [sequence, count] : counts) {
    if (++listed > 5) return list + ", and more";
    list += (list.empty() ? "" : ", ") + inQuotes(nameOf(sequence)) + " (" + grouped(count) + " files)";
  }
  return list;
}

}  // namespace shapespline
