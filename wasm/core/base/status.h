// Errors as values: the core never throws for bad input.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace shapespline {

/// Error codes. Their names are the stable codes in JavaScript (see errorCodeName).
enum class ErrorCode {
  // reading a file
  EmptyFile,
  TruncatedFile,
  NotRecognised,     ///< unknown file format
  MalformedFile,     ///< known format but damaged: a bad index, size or offset
  Unsupported,       ///< valid, but requires an unsupported feature
  MissingResource,   ///< a referenced file was not given
  ExternalResource,  ///< a URI outside the given files; never fetched
  TooLarge,          ///< a declared size exceeds memory limits
  NoTriangles,
  UnknownAnimation,
  UnknownObject,
  // mismatched keys
  TooFewKeys,
  VertexCountMismatch,
  FaceCountMismatch,
  FaceMismatch,
  IndexOutOfRange,
  NotFinite,
  NoArea,  ///< every triangle has zero area
  TimesNotIncreasing,
  TimeCountMismatch,
  // options
  InvalidOption,
  // numerics and environment
  NotPositiveDefinite,
  OutOfMemory,
  Internal,
};

/// The stable name of a code, such as "vertex-count-mismatch".
const char* errorCodeName(ErrorCode code);

/// A failure: a message with the problem, its location and a remedy, and the location as numbers if known.
/// key, vertex and face are 0-based indices in the input, row is a row of the unsolvable system, or -1. Messages count
/// keys from 1.
struct Error {
  ErrorCode code = ErrorCode::Internal;
  std::string message;
  int key = -1;
  int vertex = -1;
  int face = -1;
  int row = -1;
};

/// A value or the error that prevented it.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  bool ok() const { return std::holds_alternative<T>(state_); }
  explicit operator bool() const { return ok(); }
  T& value() { return std::get<T>(state_); }
  const T& value() const { return std::get<T>(state_); }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  const Error& error() const { return std::get<Error>(state_); }

 private:
  std::variant<T, Error> state_;
};

/// Success or an error.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(Error error) : error_(std::move(error)) {}

  bool ok() const { return !error_; }
  explicit operator bool() const { return ok(); }
  const Error& error() const { return *error_; }

 private:
  std::optional<Error> error_;
};

}  // namespace shapespline
