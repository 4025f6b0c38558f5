// Marks a function that JavaScript calls. Requests are JSON text ended by a NUL; results are valid until the next call.
#pragma once

#include <emscripten.h>

#define EXPORT extern "C" EMSCRIPTEN_KEEPALIVE
