// The part of std::stringstream that tinygltf needs (see CMakeLists.txt).
#pragma once

#include <string>

namespace shapespline {

class TextStream {
 public:
  TextStream& operator<<(const std::string& text) { return text_ += text, *this; }
  TextStream& operator<<(const char* text) { return text_ += text, *this; }
  TextStream& operator<<(char c) { return text_ += c, *this; }
  template <class Number>
  TextStream& operator<<(Number number) {
    return text_ += std::to_string(number), *this;
  }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

}  // namespace shapespline
