// The C++ library's exceptions bring in the C library's table of system error messages. Nothing here makes system
// calls, so this stub keeps the table out of the module.
#include <cstring>

extern "C" char* strerror(int) {
  static char words[] = "system error";
  return words;
}
