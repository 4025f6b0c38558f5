// What JavaScript holds by a handle: a whole number that is never used twice. Whoever creates, releases.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <variant>
#include <vector>

#include "core/mesh/principal_offsets.h"
#include "core/sequence/sequence.h"
#include "io/import.h"

namespace shapespline::bindings {

/// A shape with the frame and the ghost that it was last evaluated into, so that no frame allocates.
struct ShapeObject {
  std::shared_ptr<SharedShape> shape;
  Frame frame;
  std::vector<float> ghost;  ///< xyz of the ghost's vertices
};

/// One of its motions.
struct MotionObject {
  Sequence sequence;
  int shape;  ///< handle
};

/// An import with the key that was last asked for, in single precision, and its normals.
struct ImportObject {
  Import import;
  std::vector<float> positions;
  std::vector<float> normals;
};

using Bytes = std::vector<std::uint8_t>;
using Object = std::variant<ShapeObject, MotionObject, ImportObject, Bytes, PrincipalOffsets>;

class HandleTable {
 public:
  int add(Object object) {
    objects_.emplace(++last_, std::move(object));
    return last_;
  }

  /// Throws where the handle is stale or of another kind: a defect of the engine, never of an input.
  template <class T>
  T& get(int handle) {
    const auto found = objects_.find(handle);
    T* object = found == objects_.end() ? nullptr : std::get_if<T>(&found->second);
    if (!object) throw std::invalid_argument("stale handle");
    return *object;
  }

  void release(int handle) { objects_.erase(handle); }
  int count() const { return static_cast<int>(objects_.size()); }

 private:
  std::map<int, Object> objects_;
  int last_ = 0;
};

HandleTable& handleTable();

}  // namespace shapespline::bindings
