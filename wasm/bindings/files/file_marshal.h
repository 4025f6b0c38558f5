// Converts between JSON and heap ranges and the contents of files.
#pragma once

#include <vector>

#include "bindings/marshal.h"
#include "io/base/scene.h"
#include "io/import.h"

namespace shapespline::bindings {

ImportOptions importOptionsFrom(const Json& json);
Scene sceneFrom(const Json& json);

Json toJson(const std::vector<AnimationInfo>& animations);
Json toJson(const std::vector<MatchedObject>& matches);
Json toJson(const Scene& scene);  ///< with ranges into the scene

}  // namespace shapespline::bindings
