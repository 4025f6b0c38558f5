// JSON and heap ranges <-> the core's plain data. Bulk numbers travel as {"address", "length"}: a range of the heap
// that its owner keeps until the call, or the handle that it belongs to, is done with.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bindings/call_result.h"
#include "core/sequence/keyframes.h"
#include "core/sequence/mesh_report.h"
#include "core/sequence/options.h"
#include "core/sequence/sequence.h"
#include "io/base/scene.h"
#include "io/import.h"

namespace shapespline::bindings {

/// A range of the heap as JSON; length counts elements.
template <class T>
Json range(const T* data, std::size_t length) {
  return {{"address", reinterpret_cast<std::uintptr_t>(data)}, {"length", length}};
}

template <class T>
Json rangeOrNull(const std::vector<T>& numbers) {
  return numbers.empty() ? Json() : range(numbers.data(), numbers.size());
}

/// The range that JSON names, as elements of type T; empty for null.
template <class T>
std::span<const T> elements(const Json& json) {
  if (json.is_null()) return {};
  const auto address = json.at("address").get<std::uintptr_t>();
  return {reinterpret_cast<const T*>(address), json.at("length").get<std::size_t>()};
}

Positions positionsFrom(std::span<const float> numbers);
Vec3 vec3From(const Json& json);  ///< of three numbers
std::vector<float> floatsFrom(const Positions& positions);
std::vector<Triangle> trianglesFrom(std::span<const std::int32_t> indices);

Keyframes keyframesFrom(const Json& json);
MotionOptions motionFrom(const Json& json);
EncodingOptions encodingFrom(const Json& json);
ImportOptions importOptionsFrom(const Json& json);
Scene sceneFrom(const Json& json);

Json toJson(const std::vector<Warning>& warnings);
Json toJson(const SequenceStats& stats);
Json toJson(const std::vector<AnimationInfo>& animations);
Json toJson(const std::vector<MatchedObject>& matches);
Json toJson(const MeshReport& report);
Json toJson(const Scene& scene);  ///< ranges into the scene itself

}  // namespace shapespline::bindings
