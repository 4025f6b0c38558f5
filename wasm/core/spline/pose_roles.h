// Roles of a shape's poses for its curve.
#pragma once

namespace shapespline {

/// The keys come first among the poses, followed by the optional shapes for end tangents.
struct PoseRoles {
  int keys = 0;
  int startTangent = -1;  ///< pose index, or -1
  int endTangent = -1;

  int count() const { return keys + (startTangent >= 0) + (endTangent >= 0); }
};

}  // namespace shapespline
