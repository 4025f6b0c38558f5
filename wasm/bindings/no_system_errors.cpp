// The C++ library's exceptions bring in the C library's table of system error messages. The modules make no system
// calls, so this stub keeps the table out.
#include <cstring>

extern "C" char* strerror(int) {
  static char words[] = "system error";
  return words;
}
