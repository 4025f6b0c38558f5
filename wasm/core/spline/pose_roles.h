// What the poses of a shape are to its curve.
#pragma once

namespace shapespline {

/// The keys come first among the poses, then the shapes that stand for end tangents where there are any.
struct PoseRoles {
  int keys = 0;
  int startTangent = -1;  ///< pose index, or -1
  int endTangent = -1;

  int count() const { return keys + (startTangent >= 0) + (endTangent >= 0); }
};

}  // namespace shapespline
