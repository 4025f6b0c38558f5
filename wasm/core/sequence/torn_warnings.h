// Warns about surfaces torn by separate face rotations.
#pragma once

#include <vector>

#include "core/base/warning.h"
#include "core/space/rotation_strain_space.h"

namespace shapespline {

/// One warning per interval between keys. Warning::face is a face of the welded mesh.
std::vector<Warning> tornWarnings(const WeldedShape& shape, const RotationStrainSpace& space);

}  // namespace shapespline
