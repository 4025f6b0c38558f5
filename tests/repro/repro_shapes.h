// Generates inputs that showed defects: small, exact, and the same for files (main.cpp) and tests
// (tests/native/repro_test.cpp).
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "../native/shapes.h"

namespace shapespline::repro {

using namespace shapespline::test;

struct Repro {
  std::string name;  ///< name of the input and its folder
  Keyframes keyframes;
};

/// Rounds positions to single precision, as in a file. This noise determined in which direction a wheel turned.
inline Keyframes roundedToFloat(Keyframes k) {
  for (Key& key : k.keys)
    for (Vec3& p : key.positions) p = p.cast<float>().cast<double>();
  return k;
}

/// A closed cylinder about the y axis, centred at the origin, with two faces per segment on its side.
inline Shape cylinder(double radius, double width, int segments = 24) {
  Shape shape;
  for (const double y : {-width / 2, width / 2}) {
    for (int s = 0; s < segments; ++s)
      shape.positions.emplace_back(radius * std::cos(2 * pi * s / segments), y,
                                   radius * std::sin(2 * pi * s / segments));
    shape.positions.emplace_back(0, y, 0);
  }
  const int top = segments + 1;
  for (int s = 0; s < segments; ++s) {
    const int t = (s + 1) % segments;
    shape.faces.push_back({segments, s, t});
    shape.faces.push_back({top + segments, top + t, top + s});
    shape.faces.push_back({s, top + s, t});
    shape.faces.push_back({t, top + s, top + t});
  }
  return shape;
}

/// The pose of a car: its position along x, and the angles of steering and wheels in degrees.
struct CarPose {
  double forward = 0, steering = 0, wheels = 0;
};

/// A body (component 0) and wheels next to it that turn about the y axis (components 1 and on); x is forwards, z up.
/// Single precision.
class Car {
 public:
  explicit Car(const std::vector<Vec3>& hubs) : hubs_(hubs) {
    shape_ = box(4, 1.6, 1, 8, 4, 3);
    bodyVertices_ = static_cast<int>(shape_.positions.size());
    for (const Vec3& hub : hubs) {
      Shape wheel = cylinder(0.45, 0.25);
      wheelVertices_ = static_cast<int>(wheel.positions.size());
      for (Vec3& p : wheel.positions) p += hub;
      shape_ = joined(shape_, wheel);
    }
  }

  Keyframes keys(const std::vector<CarPose>& poses) const {
    Keyframes k;
    k.faces = shape_.faces;
    for (std::size_t j = 0; j < poses.size(); ++j) k.keys.push_back({"", double(j), posed(poses[j])});
    return roundedToFloat(std::move(k));
  }

  int wheels() const { return static_cast<int>(hubs_.size()); }
  Positions body(const Positions& p) const { return {p.begin(), p.begin() + bodyVertices_}; }
  Positions wheel(const Positions& p, int wheel) const {
    const auto first = p.begin() + bodyVertices_ + wheel * wheelVertices_;
    return {first, first + wheelVertices_};
  }
  /// Wheel that a face is of, or -1.
  int wheelOfFace(int face) const {
    const int vertex = shape_.faces[face][0];
    return vertex < bodyVertices_ ? -1 : (vertex - bodyVertices_) / wheelVertices_;
  }

 private:
  Positions posed(const CarPose& pose) const {
    const Mat3 car = expRotation(Vec3::UnitZ() * radians(pose.steering)),
               roll = expRotation(Vec3::UnitY() * radians(pose.wheels));
    Positions out;
    for (int v = 0; v < static_cast<int>(shape_.positions.size()); ++v) {
      Vec3 p = shape_.positions[v];
      if (v >= bodyVertices_) {
        const Vec3& hub = hubs_[(v - bodyVertices_) / wheelVertices_];
        p = hub + roll * (p - hub);
      }
      out.push_back(car * p + Vec3(pose.forward, 0.1 * pose.forward, 0));
    }
    return out;
  }

  std::vector<Vec3> hubs_;
  Shape shape_;
  int bodyVertices_ = 0, wheelVertices_ = 0;
};

/// One wheel next to the body.
inline Car oneWheeled() { return Car({{1.2, -1, 0.1}}); }
inline Car fourWheeled() { return Car({{1.2, -1, 0.1}, {1.2, 1, 0.1}, {-1.2, -1, 0.1}, {-1.2, 1, 0.1}}); }

/// `count` keys a second apart: the car steers by 11 degrees a key and rolls on, its wheels turn by `step` degrees.
inline std::vector<CarPose> drive(double step, int count) {
  std::vector<CarPose> poses;
  for (int j = 0; j < count; ++j) poses.push_back({1.3 * j, 11.0 * j, step * j});
  return poses;
}

/// A bar that bends by one radian per key, with a hat (component 1) on its end. In key `small`, the hat shrinks towards
/// its base, to `scale` of its size.
inline Keyframes shrinkingHat(int small, double scale) {
  const Vec3 end(0, 0, 10), seat(0, 0, 10.02);
  const Shape body = box(1, 1, 10, 4, 4, 30), both = joined(body, sphere(seat + Vec3(0, 0, 0.4), 0.4, 8, 16));
  Keyframes k;
  k.faces = both.faces;
  for (int j = 0; j < 3; ++j) {
    const Map bent = bend(j);
    const Mat3 atEnd = expRotation(Vec3(0, -j, 0));
    const double size = j == small ? scale : 1;
    Positions p = mapped(body.positions, bent);
    for (std::size_t v = p.size(); v < both.positions.size(); ++v)
      p.push_back(bent(end) + atEnd * (seat + size * (both.positions[v] - seat) - end));
    k.keys.push_back({"", double(j), std::move(p)});
  }
  return roundedToFloat(std::move(k));
}

/// A bar that bends; key 1 is the mirror image of its pose.
inline Keyframes mirroredKey() {
  const Map bent = bend(radians(40));
  return roundedToFloat(keyframes(box(1, 1.4, 6, 3, 4, 12), {bend(0),
                                                             [=](const Vec3& p) -> Vec3 {
                                                               const Vec3 q = bent(p);
                                                               return {q.x(), -q.y(), q.z()};
                                                             },
                                                             bend(radians(80))}));
}

/// A bar with a small bead next to it, whose last key is `lengths` bar lengths away.
inline Keyframes farKey(double lengths) {
  const Shape shape = joined(box(1, 1, 10, 3, 3, 24), sphere({0.7, 0, 5}, 0.05));
  const Map away = [=](const Vec3& p) -> Vec3 { return p + Vec3(0, 10 * lengths, 0); };
  return keyframes(shape, {bend(0), bend(0.6), away});
}

/// All inputs, for writing files.
inline std::vector<Repro> allRepros() {
  const Car cart = oneWheeled(), car = fourWheeled();
  return {{"wheel", cart.keys(drive(90, 5))},
          {"wheel-100", cart.keys(drive(100, 5))},
          {"wheel-120", cart.keys(drive(120, 5))},
          {"wheel-170", cart.keys(drive(170, 5))},
          {"wheel-175-two-keys", cart.keys(drive(175, 2))},
          {"wheel-240-two-keys", cart.keys(drive(240, 2))},
          {"car", car.keys(drive(90, 5))},
          {"vanishing-hat", shrinkingHat(1, 0)},
          {"mirrored-key", mirroredKey()},
          {"far-key", farKey(3900)}};
}

}  // namespace shapespline::repro
