// Objects that JavaScript refers to by handles: whole numbers, never reused. The creator releases an object.
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

namespace shapespline::bindings {

/// Objects of any type. Each module has its own types.
class HandleTable {
 public:
  template <class T>
  int add(T object) {
    objects_.emplace(++last_, Kept{&kindOf<T>, std::make_shared<T>(std::move(object))});
    return last_;
  }

  /// Throws if the handle is stale or has another type, which is always a defect of the engine.
  template <class T>
  T& get(int handle) {
    const auto found = objects_.find(handle);
    if (found == objects_.end() || found->second.kind != &kindOf<T>) throw std::invalid_argument("stale handle");
    return *static_cast<T*>(found->second.object.get());
  }

  void release(int handle) { objects_.erase(handle); }
  int count() const { return static_cast<int>(objects_.size()); }

 private:
  /// The address of this variable identifies the type, because the wasm module has no run-time type information.
  template <class T>
  static constexpr char kindOf = 0;

  struct Kept {
    const char* kind;
    std::shared_ptr<void> object;
  };

  std::map<int, Kept> objects_;
  int last_ = 0;
};

HandleTable& handleTable();

}  // namespace shapespline::bindings
