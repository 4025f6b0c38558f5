#include "bindings/objects.h"

#include "bindings/answer.h"
#include "bindings/entry.h"

namespace shapespline::bindings {

Objects& objects() {
  static Objects all;
  return all;
}

ENTRY void shapespline_release(int handle) { objects().release(handle); }

/// {count}: objects that are alive, for tests of leaks.
ENTRY const char* shapespline_objects() {
  return answer([]() -> Result<Json> { return Json{{"count", objects().count()}}; });
}

}  // namespace shapespline::bindings
