#include "io/project.h"

#include <cmath>

#define JSON_NO_IO
#include <nlohmann/json.hpp>

namespace shapespline {

Result<Project> parseProject(const std::string& text, int morphTargets) {
  const auto ignored = [](const std::string& why) {
    return Error{ErrorCode::MalformedFile, "the saved project in it is ignored: " + why + "."};
  };
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("keys") || !json["keys"].is_array()) return ignored("it has no keys");
  Project project;
  for (const auto& key : json["keys"]) {
    if (!key.is_object() || !key.contains("time") || !key["time"].is_number() || !key.contains("frame") ||
        !key["frame"].is_number_integer())
      return ignored("a key has no time or no frame");
    ProjectKey out{"", key["time"].get<double>(), key["frame"].get<int>()};
    if (key.contains("name") && key["name"].is_string()) out.name = key["name"].get<std::string>();
    if (out.frame < 0 || out.frame > morphTargets) return ignored("a key's frame is not in the file");
    if (!project.keys.empty() && !(out.time > project.keys.back().time)) return ignored("its key times do not increase");
    project.keys.push_back(std::move(out));
  }
  if (project.keys.size() < 2) return ignored("it has fewer than two keys");
  return project;
}

}  // namespace shapespline
