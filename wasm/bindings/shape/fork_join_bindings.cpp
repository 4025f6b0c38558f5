// The second thread: a second instance of the module on shared memory, with its own stack, that only helps.
#include "bindings/export.h"
#include "bindings/handle_table.h"
#include "bindings/shape/fork_join.h"
#include "bindings/shape/shape_objects.h"

namespace shapespline::bindings {

ForkJoin& forkJoin() {
  static constinit ForkJoin instance;
  return instance;
}

/// Called in the helper's instance: does second parts of frames, and never returns.
EXPORT void shapespline_help() { forkJoin().serve(); }

/// Called when the helper has trapped.
EXPORT void shapespline_help_lost() { forkJoin().breakDown(); }

/// Whether it has, or never came back: frames that it was to help with have failed.
EXPORT int shapespline_is_help_lost() { return forkJoin().lost() ? 1 : 0; }

/// Frames of this shape are made by one thread or by two from here on, to the same bits.
EXPORT void shapespline_set_threads(int handle, int threads) {
  handleTable().get<ShapeObject>(handle).shape->evaluator().setForkJoin(threads > 1 ? &forkJoin() : nullptr);
}

/// Parts of frames that the helper has done, for tests and measurements.
EXPORT double shapespline_helped() { return static_cast<double>(forkJoin().helped()); }

}  // namespace shapespline::bindings
