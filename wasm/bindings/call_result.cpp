#include "bindings/call_result.h"

#include <string>

namespace shapespline::bindings {
namespace {

std::string text;

// File names and names inside files may be invalid UTF-8. Invalid bytes are replaced.
const char* keep(const Json& json) {
  text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.c_str();
}

Json failure(const Error& error) {
  return {{"ok", false},
          {"code", errorCodeName(error.code)},
          {"message", error.message},
          {"key", error.key},
          {"vertex", error.vertex},
          {"face", error.face}};
}

}  // namespace

const char* keepResult(Result<Json> result) {
  if (!result) return keep(failure(result.error()));
  (*result)["ok"] = true;
  return keep(*result);
}

const char* keepOutOfMemory() {
  return R"({"ok":false,"code":"out-of-memory","message":"There is not enough memory. Close other pages, or )"
         R"(use fewer keys or a mesh with fewer faces.","key":-1,"vertex":-1,"face":-1})";
}

const char* keepInternal(const char* what) {
  try {
    return keep(failure(
        {ErrorCode::Internal, std::string("Internal error: ") + what + ". Please report it together with the files."}));
  } catch (...) {
    return keepOutOfMemory();
  }
}

}  // namespace shapespline::bindings
