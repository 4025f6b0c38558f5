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
  bool isPosed = false;         ///< some file by one animation, which does not move
};

/// Warns of neighbouring keys that are one pose: which, why that happens, and what to do.
void warnOfSamePoses(const FileFacts& facts, Import& import);

/// Whether all keys are one pose.
bool allSame(const Keyframes& keyframes);

/// Which way shapes stand that are taken to have y up.
enum class Standing { AlongY, AlongZ, PerhapsAlongZ, Unknown };

/// Along an axis: some pose would tip over along the other one, none the other way round, and all of them stand on that
/// axis' own floor and not on the other's. Perhaps along z: the first pose has a flat base there, or more poses would
/// tip over along y than along z. `flat`: a flat base on the floor is enough, too; not for files that mostly have y up.
Standing standingOf(const Keyframes& keyframes, bool flat);

/// Of files that do not say which axis is up, and seem to have z up, clearly or perhaps.
Warning zUpWarning(const std::string& where, bool clearly);

/// Of a file that says that Blender wrote it; `clearly`: its shapes do not stand along y.
Warning blenderWarning(const std::string& where, bool clearly);

}  // namespace shapespline
