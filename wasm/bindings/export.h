// Marks a function for calls from JavaScript. Requests are NUL-terminated JSON text. Results are valid until the next
// call.
#pragma once

#include <emscripten.h>

#define EXPORT extern "C" EMSCRIPTEN_KEEPALIVE
