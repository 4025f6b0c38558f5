// The module's second thread: another instance on the same memory may help.
#pragma once

#include "core/base/fork_join.h"

namespace shapespline::bindings {

ForkJoin& forkJoin();

}  // namespace shapespline::bindings
