#include "io/gltf/project.h"

#include <cmath>
#include <cstdint>

#define JSON_NO_IO
#include <nlohmann/json.hpp>

namespace shapespline {

namespace {

using nlohmann::json;

Error ignored(const std::string& why) {
  return {ErrorCode::MalformedFile, "the project in this file cannot be read (" + why + "). Only its shapes are used."};
}

// A list of `size` items that all pass the test, or nothing.
template <class Test>
const json* list(const json& keys, const char* name, std::size_t size, Test test) {
  const auto it = keys.find(name);
  if (it == keys.end() || !it->is_array() || it->size() != size) return nullptr;
  for (const json& item : *it)
    if (!test(item)) return nullptr;
  return &*it;
}

}  // namespace

Result<Project> parseProject(const std::string& text, int morphTargets, bool animated) {
  // Parses from char*, like all code here: the library instantiates a parser for each iterator type.
  const json document = json::parse(text.data(), text.data() + text.size(), nullptr, false);
  const json keys = document.is_object() ? document.value("keys", json()) : json();
  if (!keys.is_object() || !keys.contains("times") || !keys["times"].is_array()) return ignored("it has no keys");
  const std::size_t count = keys["times"].size();
  if (count < 2) return ignored("it has fewer than two keys");
  const auto isNumber = [](const json& v) { return v.is_number(); };
  const json* times = list(keys, "times", count, isNumber);
  const json* seconds = animated ? list(keys, "seconds", count, isNumber) : nullptr;
  const json* names = list(keys, "names", count, [](const json& v) { return v.is_string(); });
  const json* frames = list(keys, "frames", count, [&](const json& v) {
    return v.is_number_unsigned() && v.get<std::uint64_t>() <= static_cast<std::uint64_t>(morphTargets);
  });
  if (!times) return ignored("a key has no time");
  if (!frames && !seconds) return ignored("it does not state which frames are its keys");

  Project project;
  if (const json* offset = list(document, "offset", 3, isNumber))
    for (int c = 0; c < 3; ++c) project.offset[c] = (*offset)[c].get<double>();
  if (!project.offset.allFinite()) project.offset.setZero();
  for (std::size_t k = 0; k < count; ++k) {
    ProjectKey key;
    key.time = (*times)[k].get<double>();
    if (names) key.name = (*names)[k].get<std::string>();
    if (frames) key.frame = (*frames)[k].get<int>();
    else key.seconds = (*seconds)[k].get<double>();
    if (k > 0 && !(key.time > project.keys.back().time)) return ignored("its key times do not increase");
    project.keys.push_back(std::move(key));
  }
  return project;
}

}  // namespace shapespline
