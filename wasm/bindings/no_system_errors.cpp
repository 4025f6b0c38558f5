// Nothing here asks a system for anything, so that no error of one needs words: the C library's table of them, which
// the C++ library's exceptions bring, stays out of the module.
#include <cstring>

extern "C" char* strerror(int) {
  static char words[] = "system error";
  return words;
}
