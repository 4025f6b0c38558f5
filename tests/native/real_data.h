// Files from other sources, if available: in the folder SHAPESPLINE_DATA, or in shared/data beside the repository.
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "files.h"

namespace shapespline::test {

inline std::filesystem::path dataFolder() {
  if (const char* named = std::getenv("SHAPESPLINE_DATA")) return named;
  return std::filesystem::path(SHAPESPLINE_SOURCE_DIR).parent_path() / "shared" / "data";
}

/// Whether the folder and the given files in it exist. If not, the case should return: it counts as skipped (main.cpp),
/// or fails if SHAPESPLINE_DATA_REQUIRED is set.
inline bool hasData(const std::vector<std::string>& paths = {}) {
  const auto skip = [](const std::filesystem::path& missing) {
    REQUIRE_MESSAGE(!std::getenv("SHAPESPLINE_DATA_REQUIRED"), missing.string());
    MESSAGE("SKIPPED: " << missing.string() << " is not there");
    return false;
  };
  if (!std::filesystem::exists(dataFolder())) return skip(dataFolder());
  for (const std::string& path : paths)
    if (!std::filesystem::exists(dataFolder() / path)) return skip(dataFolder() / path);
  return true;
}

inline Bytes contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  REQUIRE_MESSAGE(stream.good(), file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline const std::vector<std::string> wolfPoses = {"obj/wolf/wolf-1.obj",  "obj/wolf/wolf-4.obj",
                                                   "obj/wolf/wolf-8.obj",  "obj/wolf/wolf-12.obj",
                                                   "obj/wolf/wolf-16.obj", "obj/wolf/wolf-20.obj"};
/// In the order of their numbers, which is not that of a motion; rotations of up to 175 degrees.
inline const std::vector<std::string> lionPoses = {"turns/lion/1.obj", "turns/lion/2.obj", "turns/lion/3.obj",
                                                   "turns/lion/4.obj", "turns/lion/5.obj", "turns/lion/6.obj",
                                                   "turns/lion/7.obj", "turns/lion/8.obj", "turns/lion/9.obj"};

/// Reads files of the folder. The results have names without folders.
inline Files realFiles(const std::vector<std::string>& paths) {
  Files files;
  for (const std::string& path : paths)
    files.add(std::filesystem::path(path).filename().string(), contentOf(dataFolder() / path));
  return files;
}

inline Keyframes realKeyframes(const std::vector<std::string>& paths, const ImportOptions& options = {}) {
  auto import = realFiles(paths).import(options);
  REQUIRE_MESSAGE(import.ok(), (import.ok() ? "" : import.error().message));
  return std::move(import->keyframes);
}

}  // namespace shapespline::test
