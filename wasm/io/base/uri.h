// Resolves URIs in a file to bytes of the given files. Nothing is fetched or opened. web/engine/api/paths.ts applies
// the same rules to compressed files, which are decoded before the core reads them, and to the command line, which
// reads companion files from disk. Both pass tests/uri-cases.json.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/status.h"
#include "io/base/source_files.h"

namespace shapespline {

/// Bytes for a URI, from a given file or decoded from a data URI.
struct Resource {
  std::span<const std::uint8_t> bytes;  ///< points into a given file or into `owned`
  std::vector<std::uint8_t> owned;
  std::string mimeType;  ///< stated by a data URI, else empty

  Resource() = default;
  Resource(Resource&&) = default;  // no copy constructor: a copied span would point into the original
  Resource& operator=(Resource&&) = default;
};

/// Resolves `uri` relative to the file `from`. Folders count if the file names contain them. Files dropped without
/// folders are found by name alone. `where`: display name of the file with the URI.
/// Errors: ExternalResource for other schemes, hosts and paths that leave the given files; MissingResource;
/// MalformedFile for a data URI that cannot be decoded.
Result<Resource> resolveUri(std::string_view uri, std::string_view from, const SourceFiles& files,
                            const std::string& where);

}  // namespace shapespline
