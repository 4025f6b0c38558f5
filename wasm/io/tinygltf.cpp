// The one place where tinygltf's code is compiled.
//
// tinygltf puts its messages together with std::stringstream, which alone would bring the streams and locales of the C++
// library into the wasm module (a tenth of its size). Under other names it gets a few lines that do the same.
#define JSON_NO_IO
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>

namespace std {  // tinygltf spells the std:: out
inline constexpr char tinygltf_endl[] = "\n";

class tinygltf_stringstream {
 public:
  tinygltf_stringstream& operator<<(const std::string& text) { return text_ += text, *this; }
  tinygltf_stringstream& operator<<(const char* text) { return text_ += text, *this; }
  tinygltf_stringstream& operator<<(char c) { return text_ += c, *this; }
  template <class Number>
  tinygltf_stringstream& operator<<(Number number) { return text_ += std::to_string(number), *this; }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
};
}  // namespace std

#define stringstream tinygltf_stringstream
#define endl tinygltf_endl
#define TINYGLTF_IMPLEMENTATION
#include "io/tinygltf.h"
