// Error for a file that violates the glTF format.
#pragma once

#include <string>

#include "core/base/status.h"

namespace shapespline {

/// `where`: display name of the file.
inline Error malformed(const std::string& where, const std::string& what) {
  return {ErrorCode::MalformedFile, where + ": " + what + ". Export the file again."};
}

}  // namespace shapespline
