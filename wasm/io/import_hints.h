// Warnings about keys that look wrong: equal poses, shapes that lie on their backs.
#pragma once

#include <string>
#include <vector>

#include "core/base/warning.h"
#include "io/base/imported.h"

namespace shapespline {

/// Facts about the files of several poses.
struct FileFacts {
  int files = 0, skinned = 0;   ///< all that were read; those with bones
  int animated = 0, posed = 0;  ///< with a motion of the mesh; with nothing but animations that are one pose each
  bool gltf = false;            ///< all of them are glTF
  bool isPosed = false;         ///< some file by one animation, which does not move
};

/// Warns about neighbouring keys that are the same pose, with the reason and advice.
void warnOfSamePoses(const FileFacts& facts, Import& import);

/// Whether all keys are one pose.
bool allSame(const Keyframes& keyframes);

/// Which way shapes stand that are taken to have y up.
enum class Standing { AlongY, AlongZ, PerhapsAlongZ, Unknown };

/// Along an axis: some pose would tip over along the other axis, no pose along this one, and all poses stand on this
/// axis' floor and not on the other's. Perhaps along Z: the first pose has a flat base there, or more poses would tip
/// over along Y than along Z. `flat`: a flat base on the floor suffices; not for formats that mostly have Y up.
Standing standingOf(const Keyframes& keyframes, bool flat);

/// Warning for files that do not state their up axis, but appear to be Z up, clearly or perhaps.
Warning zUpWarning(const std::string& where, bool clearly);

/// Warning for a file written by Blender; `clearly`: its shapes do not stand along Y.
Warning blenderWarning(const std::string& where, bool clearly);

}  // namespace shapespline
