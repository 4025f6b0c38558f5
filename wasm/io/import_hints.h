// Warnings about suspicious keys: equal poses, shapes lying down.
#pragma once

#include <string>
#include <vector>

#include "core/base/warning.h"
#include "io/base/imported.h"

namespace shapespline {

/// Facts about the files of a multi-file import.
struct FileFacts {
  int files = 0, skinned = 0;   ///< number of all files read, and of those with bones
  int animated = 0, posed = 0;  ///< files with a motion of the mesh; files with single-pose animations only
  bool gltf = false;            ///< all files are glTF
  bool isPosed = false;         ///< some file is posed by a still animation
};

/// Warns about equal neighbouring keys, with the reason and advice.
void warnOfSamePoses(const FileFacts& facts, Import& import);

/// Warns about a key that is much larger or smaller than the others, as in another unit. `where`: display names of the
/// keys' files.
void warnOfSizes(const std::vector<std::string>& files, Import& import);

/// Whether all keys have the same pose.
bool allSame(const Keyframes& keyframes);

/// Warns of at least four evenly spaced keys of an animation whose second differences exceed 1.4 times the first (rms
/// over vertices and keys). Straight lines are then closer to the animation than a spline.
void warnOfDistantKeys(Import& import);

/// The likely up axis of shapes that are imported as Y up.
enum class UpAxisGuess { AlongY, AlongZ, PerhapsAlongZ, Unknown };

/// AlongY, AlongZ: some pose would tip over along the other axis, no pose along this one, and all poses stand on this
/// axis' floor only. PerhapsAlongZ: the first pose has a flat base along Z, or more poses would tip over along Y than
/// along Z. `flat`: accept a flat base on the floor as proof; not for formats that are mostly Y up.
UpAxisGuess guessUpAxis(const Keyframes& keyframes, bool flat);

/// Warning for files that do not state their up axis but appear to be Z up. `clearly`: certain, not just likely.
Warning zUpWarning(const std::string& where, bool clearly);

/// Warning for a file written by Blender. `clearly`: its shapes do not stand along Y.
Warning blenderWarning(const std::string& where, bool clearly);

}  // namespace shapespline
