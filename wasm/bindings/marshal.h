// Converts between JSON and heap ranges and the core's plain data, in all modules. Large arrays are passed as
// {"address", "length"}: a heap range that its owner keeps until the call ends or its handle is released.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bindings/call_result.h"
#include "core/base/types.h"
#include "core/base/warning.h"
#include "core/sequence/mesh_report.h"

namespace shapespline::bindings {

/// A heap range as JSON. length counts elements.
template <class T>
Json range(const T* data, std::size_t length) {
  return {{"address", reinterpret_cast<std::uintptr_t>(data)}, {"length", length}};
}

template <class T>
Json rangeOrNull(const std::vector<T>& numbers) {
  return numbers.empty() ? Json() : range(numbers.data(), numbers.size());
}

/// The heap range in the JSON, as elements of type T; empty for null.
template <class T>
std::span<const T> elements(const Json& json) {
  if (json.is_null()) return {};
  const auto address = json.at("address").get<std::uintptr_t>();
  return {reinterpret_cast<const T*>(address), json.at("length").get<std::size_t>()};
}

/// The value of a name. The engine checks every name before the call, so an unknown name is a defect and gives an
/// internal error.
template <class T, std::size_t count>
T named(const Json& json, const std::pair<const char*, T> (&names)[count]) {
  const auto text = json.get<std::string>();
  for (const auto& [name, value] : names) {
    if (text == name) return value;
  }
  throw std::invalid_argument("unknown choice: " + text);
}

Positions positionsFrom(std::span<const float> numbers);
Vec3 vec3From(const Json& json);  ///< three numbers
std::vector<float> floatsFrom(const Positions& positions);
std::vector<Triangle> trianglesFrom(std::span<const std::int32_t> indices);

Json toJson(const std::vector<Warning>& warnings);
Json toJson(const MeshReport& report);

}  // namespace shapespline::bindings
