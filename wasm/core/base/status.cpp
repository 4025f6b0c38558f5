#include "core/base/status.h"

namespace shapespline {

const char* errorCodeName(ErrorCode code) {
  switch (code) {  // no default, so the compiler reports a missing code
    case ErrorCode::EmptyFile: return "empty-file";
    case ErrorCode::TruncatedFile: return "truncated-file";
    case ErrorCode::NotRecognised: return "not-recognised";
    case ErrorCode::MalformedFile: return "malformed-file";
    case ErrorCode::Unsupported: return "unsupported";
    case ErrorCode::MissingResource: return "missing-resource";
    case ErrorCode::ExternalResource: return "external-resource";
    case ErrorCode::TooLarge: return "too-large";
    case ErrorCode::NoTriangles: return "no-triangles";
    case ErrorCode::UnknownAnimation: return "unknown-animation";
    case ErrorCode::UnknownObject: return "unknown-object";
    case ErrorCode::TooFewKeys: return "too-few-keys";
    case ErrorCode::VertexCountMismatch: return "vertex-count-mismatch";
    case ErrorCode::FaceCountMismatch: return "face-count-mismatch";
    case ErrorCode::FaceMismatch: return "face-mismatch";
    case ErrorCode::IndexOutOfRange: return "index-out-of-range";
    case ErrorCode::NotFinite: return "not-finite";
    case ErrorCode::NoArea: return "no-area";
    case ErrorCode::TimesNotIncreasing: return "times-not-increasing";
    case ErrorCode::TimeCountMismatch: return "time-count-mismatch";
    case ErrorCode::InvalidOption: return "invalid-option";
    case ErrorCode::NotPositiveDefinite: return "not-positive-definite";
    case ErrorCode::OutOfMemory: return "out-of-memory";
    case ErrorCode::Internal: return "internal";
  }
  return "internal";
}

}  // namespace shapespline
