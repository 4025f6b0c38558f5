// Errors as values: nothing in the core throws for bad input.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace shapespline {

/// What went wrong. The names are the stable codes that JavaScript sees (see errorCodeName).
enum class ErrorCode {
  // reading a file
  EmptyFile,
  TruncatedFile,
  NotRecognised,     ///< the bytes are no format that is read here
  MalformedFile,     ///< the right format, but broken: a bad index, size or offset
  Unsupported,       ///< valid, but needs something that is not supported
  MissingResource,   ///< a file that a given file refers to was not given
  ExternalResource,  ///< a URI that leaves the given files; never fetched
  TooLarge,          ///< a declared size beyond what can be held
  NoTriangles,
  UnknownAnimation,
  UnknownObject,
  // keys that do not fit together
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
  // numerics and machine
  NotPositiveDefinite,
  OutOfMemory,
  Internal,
};

/// The stable name of a code, such as "vertex-count-mismatch".
const char* errorCodeName(ErrorCode code);

/// One failure: a sentence that says what, where and what to do, and the place in numbers where there is one.
/// key, vertex and face are 0-based indices of the input, row is one of the system that could not be solved, or -1;
/// message counts keys from 1, as people do.
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
