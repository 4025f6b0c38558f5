// Converts between JSON and heap ranges and data of shapes and motions.
#pragma once

#include "bindings/marshal.h"
#include "core/sequence/keyframes.h"
#include "core/sequence/options.h"
#include "core/sequence/sequence.h"

namespace shapespline::bindings {

Keyframes keyframesFrom(const Json& json);
MotionOptions motionFrom(const Json& json);
EncodingOptions encodingFrom(const Json& json);

Json toJson(const SequenceStats& stats);

}  // namespace shapespline::bindings
