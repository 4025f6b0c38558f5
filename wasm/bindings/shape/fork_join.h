// The module's second thread: another instance over the same memory may help in it.
#pragma once

#include "core/base/fork_join.h"

namespace shapespline::bindings {

ForkJoin& forkJoin();

}  // namespace shapespline::bindings
