#include "io/base/source_files.h"

#include <vector>

#include "io/base/byte_text.h"

namespace shapespline {

namespace {

struct Path {
  std::string text;     // segments joined by '/', with "." and ".." resolved
  bool leaves = false;  // true if the path leaves its start folder
};

Path normalised(std::string_view path) {
  std::vector<std::string_view> segments;
  Path out;
  while (!path.empty()) {
    const std::size_t slash = path.find_first_of("/\\");
    const std::string_view segment = path.substr(0, slash);
    path.remove_prefix(slash == std::string_view::npos ? path.size() : slash + 1);
    if (segment.empty() || segment == ".") continue;
    const bool goesBack = segment == ".." && !segments.empty() && segments.back() != "..";
    if (goesBack) segments.pop_back();
    else segments.push_back(segment);
  }
  out.leaves = !segments.empty() && segments.front() == "..";
  for (std::string_view segment : segments) out.text += (out.text.empty() ? "" : "/") + std::string(segment);
  return out;
}

std::string_view folderOf(std::string_view path) { return path.substr(0, path.size() - baseName(path).size()); }

}  // namespace

bool leavesItsFolder(std::string_view path) { return normalised(path).leaves; }

SourceFiles::SourceFiles(std::span<const NamedBytes> files) {
  for (const NamedBytes& file : files) {
    bytes_ += file.bytes.size();
    byPath_.emplace(normalised(file.name).text, &file);
    const auto [known, isNew] = byBaseName_.emplace(baseName(file.name), &file);
    if (!isNew) known->second = nullptr;
  }
}

const NamedBytes* SourceFiles::find(std::string_view path, std::string_view from) const {
  const auto inFolder = byPath_.find(normalised(std::string(folderOf(from)) + std::string(path)).text);
  if (inFolder != byPath_.end()) return inFolder->second;
  if (leavesItsFolder(path)) return nullptr;
  const auto byName = byBaseName_.find(baseName(path));
  return byName == byBaseName_.end() ? nullptr : byName->second;
}

}  // namespace shapespline
