#include "bindings/handle_table.h"

#include "bindings/call_result.h"
#include "bindings/export.h"

namespace shapespline::bindings {

HandleTable& handleTable() {
  static HandleTable all;
  return all;
}

EXPORT void shapespline_release(int handle) { handleTable().release(handle); }

/// {count}: the number of live objects, for leak tests.
EXPORT const char* shapespline_objects() {
  return callResult([]() -> Result<Json> { return Json{{"count", handleTable().count()}}; });
}

}  // namespace shapespline::bindings
