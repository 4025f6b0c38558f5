// The part of std::stringstream that tinygltf needs (see CMakeLists.txt).
#pragma once

#include <string>

namespace shapespline {

class TextStream {
 public:
  TextStream& operator<<(const std::string& text) { return add(text); }
  TextStream& operator<<(const char* text) { return add(text); }
  TextStream& operator<<(char c) { return add(c); }
  template <class Number>
  TextStream& operator<<(Number number) {
    return add(std::to_string(number));
  }
  const std::string& str() const { return text_; }

 private:
  template <class Text>
  TextStream& add(const Text& text) {
    text_ += text;
    return *this;
  }

  std::string text_;
};

}  // namespace shapespline
