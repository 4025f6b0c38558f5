// The second thread: another instance of the module on shared memory, with its own stack. It only helps.
#include "bindings/export.h"
#include "bindings/handle_table.h"
#include "bindings/shape/fork_join.h"
#include "bindings/shape/shape_objects.h"

namespace shapespline::bindings {

ForkJoin& forkJoin() {
  static constinit ForkJoin instance;
  return instance;
}

/// Called in the helper's instance. Computes second parts of frames and never returns.
EXPORT void shapespline_help() { forkJoin().serve(); }

/// Called after the helper has trapped.
EXPORT void shapespline_help_lost() { forkJoin().breakDown(); }

/// Whether the helper has trapped or has not returned. Frames in progress with the helper have then failed.
EXPORT int shapespline_is_help_lost() { return forkJoin().lost() ? 1 : 0; }

/// Sets the number of threads for frames of this shape, 1 or 2. Both give the same bits.
EXPORT void shapespline_set_threads(int handle, int threads) {
  handleTable().get<ShapeObject>(handle).shape->evaluator().setForkJoin(threads > 1 ? &forkJoin() : nullptr);
}

/// Number of parts of frames done by the helper, for tests and measurements.
EXPORT double shapespline_helped() { return static_cast<double>(forkJoin().helped()); }

}  // namespace shapespline::bindings
