// Finds source files by name.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "io/base/named_bytes.h"

namespace shapespline {

/// Whether `path` leaves its start folder.
bool leavesItsFolder(std::string_view path);

/// A view of all source files, indexed by name. The files must outlive it.
class SourceFiles {
 public:
  explicit SourceFiles(std::span<const NamedBytes> files);

  bool empty() const { return byPath_.empty(); }
  std::uint64_t bytes() const { return bytes_; }  ///< total size of all files

  /// Finds the file at `path`, relative to the file `from`, or returns null. If a path stays inside its folder, the
  /// base name alone suffices when it is unique. Files are often dropped without their folders.
  const NamedBytes* find(std::string_view path, std::string_view from) const;

 private:
  std::uint64_t bytes_ = 0;
  std::unordered_map<std::string, const NamedBytes*> byPath_;           // keys have "." and ".." resolved
  std::unordered_map<std::string_view, const NamedBytes*> byBaseName_;  // null if several files have the name
};

}  // namespace shapespline
