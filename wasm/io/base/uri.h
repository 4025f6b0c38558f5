// URIs inside a file -> bytes of the given files. Nothing is fetched or opened. web/engine/api/paths.ts has the same
// rules, for compressed files, which are decoded before the core reads them, and for the command line, which reads
// companions from disk. Both pass tests/uri-cases.json.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/status.h"
#include "io/base/given_files.h"

namespace shapespline {

/// Bytes that a URI stands for: of one of the given files, or decoded from a data URI.
struct Resource {
  std::span<const std::uint8_t> bytes;  ///< into a given file, or into `owned`
  std::vector<std::uint8_t> owned;
  std::string mimeType;  ///< as a data URI states it, else empty

  Resource() = default;
  Resource(Resource&&) = default;  // a copy's span would point into the original
  Resource& operator=(Resource&&) = default;
};

/// Looks `uri` up, seen from the file `from`. Folders are followed where the files' names have them; files dropped
/// without their folders are found by name alone. `where` is how messages call the file that holds the URI.
/// Errors: ExternalResource for other schemes, hosts and paths that leave the given files; MissingResource;
/// MalformedFile for a data URI that cannot be decoded.
Result<Resource> resolveUri(std::string_view uri, std::string_view from, const GivenFiles& files,
                            const std::string& where);

}  // namespace shapespline
