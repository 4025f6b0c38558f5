// A minimal snprintf: the JSON library uses it to write hexadecimal numbers in messages and escaped text. The C
// library's version would add 128-bit decimals and the texts of all error numbers. Any other format is a trap, not a
// wrong text.
#include <cstdarg>
#include <cstddef>

extern "C" int snprintf(char* text, std::size_t size, const char* format, ...) {
  va_list numbers;
  va_start(numbers, format);
  std::size_t length = 0;
  const auto put = [&](char c) {
    if (length + 1 < size) text[length] = c;
    ++length;
  };
  for (; *format; ++format) {
    if (*format != '%') {
      put(*format);
      continue;
    }
    int digits = 0;
    for (++format; *format == '.' || *format == 'h' || (*format >= '0' && *format <= '9'); ++format)
      if (*format > '0' && *format <= '9') digits = *format - '0';
    if (*format != 'x' && *format != 'X') __builtin_trap();
    const char letter = *format == 'X' ? 'A' : 'a';
    const unsigned number = va_arg(numbers, unsigned);
    for (int k = 7; k >= 0; --k)
      if (const unsigned digit = number >> (4 * k) & 15; k < digits || number >> (4 * k))
        put(static_cast<char>(digit < 10 ? '0' + digit : letter + digit - 10));
  }
  va_end(numbers);
  if (size > 0) text[length < size ? length : size - 1] = 0;
  return static_cast<int>(length);
}
