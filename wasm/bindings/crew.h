// The module's crew: a second instance over the same memory may help in it.
#pragma once

#include "core/crew.h"

namespace shapespline::bindings {

Crew& crew();

}  // namespace shapespline::bindings
