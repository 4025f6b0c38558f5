// The error of a glTF file that breaks the format's rules.
#pragma once

#include <string>

#include "core/base/status.h"

namespace shapespline {

/// `where`: how messages call the file.
inline Error malformed(const std::string& where, const std::string& what) {
  return {ErrorCode::MalformedFile, where + ": " + what + ". Export the file again."};
}

}  // namespace shapespline
