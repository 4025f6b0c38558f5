// The module's crew: a second instance over the same memory may help in it.
#pragma once

#include "core/base/fork_join.h"

namespace shapespline::bindings {

Crew& crew();

}  // namespace shapespline::bindings
