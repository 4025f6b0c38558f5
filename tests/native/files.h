// In-memory files for the importer.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/import.h"

namespace shapespline::test {

using Bytes = std::vector<std::uint8_t>;

inline Bytes bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

/// Files that own their bytes.
struct Files {
  std::vector<std::string> names;
  std::vector<Bytes> bytes;

  Files& add(std::string name, Bytes content) {
    names.push_back(std::move(name));
    bytes.push_back(std::move(content));
    return *this;
  }

  Result<Import> import(const ImportOptions& options = {}) const {
    std::vector<NamedBytes> files;
    for (std::size_t i = 0; i < names.size(); ++i) files.push_back({names[i], bytes[i]});
    return importKeyframes(files, options);
  }
};

}  // namespace shapespline::test
