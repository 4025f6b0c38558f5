// The second thread, in a module whose memory is shared: it is an instance of its own, with its own stack, that only helps.
#include "bindings/crew.h"
#include "bindings/entry.h"
#include "bindings/objects.h"

namespace shapespline::bindings {

Crew& crew() {
  static constinit Crew instance;
  return instance;
}

/// Called in the helper's instance: does second parts of frames, and never returns.
ENTRY void shapespline_help() { crew().serve(); }

/// Called when the helper has trapped.
ENTRY void shapespline_help_lost() { crew().breakDown(); }

/// Whether it has, or never came back: frames that it was to help with have failed.
ENTRY int shapespline_is_help_lost() { return crew().lost() ? 1 : 0; }

/// Frames of this handle are made by one thread or by two from here on, to the same bits.
ENTRY void shapespline_set_threads(int handle, int threads) {
  objects().get<SequenceObject>(handle).sequence.setCrew(threads > 1 ? &crew() : nullptr);
}

/// Parts of frames that the helper has done, for tests and measurements.
ENTRY double shapespline_helped() { return static_cast<double>(crew().helped()); }

}  // namespace shapespline::bindings
