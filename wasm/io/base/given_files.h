// The files that were given, found by their names.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "io/base/named_bytes.h"

namespace shapespline {

/// Whether `path` leaves the folder where it starts.
bool leavesItsFolder(std::string_view path);

/// A view of all given files, with an index of their names. The files outlive it.
class GivenFiles {
 public:
  explicit GivenFiles(std::span<const NamedBytes> files);

  bool empty() const { return byPath_.empty(); }
  std::uint64_t bytes() const { return bytes_; }  ///< of all files together

  /// The file at `path`, relative to the file `from`. A path that stays in its folder also finds the only file of its
  /// name, because files are often dropped without their folders. Null if there is none.
  const NamedBytes* find(std::string_view path, std::string_view from) const;

 private:
  std::uint64_t bytes_ = 0;
  std::unordered_map<std::string, const NamedBytes*> byPath_;           // "." and ".." resolved
  std::unordered_map<std::string_view, const NamedBytes*> byBaseName_;  // null where several files have the name
};

}  // namespace shapespline
