// One result per call: JSON text, {"ok": true, ...} or {"ok": false, "code", "message", "key", "vertex", "face"}. No
// exception crosses the boundary.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "core/base/status.h"

namespace shapespline::bindings {

using Json = nlohmann::json;

/// Stores a text until the next result.
const char* keepResult(Result<Json> result);
const char* keepOutOfMemory();
const char* keepInternal(const char* what);

/// Runs `work`, which returns Result<Json>, and turns its value, error or exception into a result.
template <class Work>
const char* callResult(Work&& work) {
  try {
    return keepResult(work());
  } catch (const std::bad_alloc&) {
    return keepOutOfMemory();
  } catch (const std::length_error&) {  // a container requested an impossible size
    return keepOutOfMemory();
  } catch (const std::exception& error) {
    return keepInternal(error.what());
  } catch (...) {
    return keepInternal("unknown exception");
  }
}

/// Runs `work` with a request, parsed from JSON text.
template <class Work>
const char* answer(const char* request, Work&& work) {
  return callResult([&] { return work(Json::parse(request)); });
}

}  // namespace shapespline::bindings
