// What an import's keys let one suspect: poses that are all the same, shapes that lie on their backs.
#pragma once

#include <string>
#include <vector>

#include "core/base/warning.h"
#include "io/base/imported.h"

namespace shapespline {

/// What the files of several poses hold besides them.
struct FileFacts {
  int files = 0, skinned = 0;   ///< all that were read; those with bones
  int animated = 0, posed = 0;  ///< with a motion of the mesh; with nothing but animations that are one pose each
  bool gltf = false;            ///< all of them are glTF
};

/// Warns of neighbouring keys that are one pose: which, why that happens, and what to do.
void warnOfSamePoses(const FileFacts& facts, Import& import);

/// Whether all keys are one pose.
bool allSame(const Keyframes& keyframes);

/// Whether poses that are taken to have y up seem to stand along z: the first one on a flat base, or more of them on
/// feet that they would tip over from along y than the other way round. `clearly`: only where no pose stands the other
/// way round, and all of them on the plane z = 0; for files that mostly have y up.
bool standOnZ(const Keyframes& keyframes, bool clearly);

/// Of a PLY, OFF or OBJ file that was read with y up. `byBlender`: the file says that it was written there.
Warning zUpWarning(const std::string& where, bool byBlender);

}  // namespace shapespline
