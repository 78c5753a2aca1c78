// SPDX-License-Identifier: Apache-2.0
// One narrow upright cut through the scene: the plane of all rays of an image column at one x.
// Every shape meets it in at most one stretch of rows whose ends are exact, so that edges can be
// anti-aliased by coverage.
#pragma once

#include <array>
#include <optional>

#include "tools/sim/camera/FieldCamera.h"
#include "tools/sim/camera/Scene.h"

namespace kelpie::sim {

// Rows [top, bottom) show one colour, brightened from litTop to litBottom.
struct Span {
  double top = 0.0;
  double bottom = 0.0;
  double depth = 0.0;  // cm along the optical axis
  Colour colour;
  double litTop = 1.0;
  double litBottom = 1.0;
  float carpet = 0.0F;   // share of the carpet's texture that shows
  double darkens = 0.0;  // > 0: no paint, what is below loses this share of its light
};

// A quad's corners from a camera, cm along its axes: the same for all planes of a column.
struct SeenQuad {
  const Quad* shape = nullptr;
  std::array<double, 4> right{};
  std::array<double, 4> down{};
  std::array<double, 4> depth{};
  bool turnedAway = false;
};
// A quad's corners by coordinate, four at a time.
struct Corners {
  std::array<double, 4> x;
  std::array<double, 4> y;
  std::array<double, 4> z;
};
Corners cornersOf(const Quad& shape);
void see(const FieldCamera& camera, const Quad& shape, const Corners& corners, SeenQuad& seen);
inline SeenQuad seenBy(const FieldCamera& camera, const Quad& shape) {
  SeenQuad seen;
  see(camera, shape, cornersOf(shape), seen);
  return seen;
}

constexpr std::array<float, kImageHeight> rowMiddles() {
  std::array<float, kImageHeight> middle{};
  for (std::size_t row = 0; row < kImageHeight; ++row) middle[row] = static_cast<float>(row) + 0.5F;
  return middle;
}
constexpr std::array<float, kImageHeight> kRowMiddles = rowMiddles();

class Slice {
 public:
  // The column plane through image coordinate x (0..208).
  Slice(const FieldCamera& camera, double x);

  // Whether a sphere can touch the plane within `margin` (share of its depth) to both sides.
  bool mayMeet(FieldPoint3 centre, double radius, double margin) const;

  // Of one that is not turned away. Here, since most that are asked the plane does not meet.
  std::optional<Span> quad(const SeenQuad& shape) const {
    return meets(shape) ? met(shape) : std::nullopt;
  }
  std::optional<Span> quad(const Quad& shape) const {
    const SeenQuad seen = seenBy(camera_, shape);
    return seen.turnedAway ? std::nullopt : quad(seen);
  }
  std::optional<Span> disc(const Disc& shape) const;
  std::optional<Span> sphere(const Sphere& shape) const;
  std::optional<Span> limb(const Limb& shape) const;
  std::optional<Span> band(const Cylinder& shape, std::size_t index) const;
  // The ground up to the line of equal elevation.
  std::optional<Span> ground(Colour colour) const;
  // Where the ray through a row meets the ground, with its depth; nothing above the horizon.
  struct GroundHit {
    double x;
    double y;
    double depth;
  };
  std::optional<GroundHit> groundAt(double row) const;
  // The same for the middles of all rows, to 10 km; depth 0 above the horizon.
  struct GroundRows {
    std::array<float, kImageHeight> x;
    std::array<float, kImageHeight> y;
    std::array<float, kImageHeight> depth;
  };
  GroundRows groundRows() const;

 private:
  struct Seen {  // a point of the plane: down and forward of the camera
    double down;
    double depth;
    double height;
  };
  // Whether the plane parts the quad's corners.
  bool meets(const SeenQuad& shape) const {
    int left = 0;
    for (std::size_t i = 0; i < 4; ++i) left += shape.right[i] - u_ * shape.depth[i] < 0.0 ? 1 : 0;
    return left > 0 && left < 4;
  }
  std::optional<Span> met(const SeenQuad& shape) const;
  double rowOf(double down, double depth) const;
  Seen seen(FieldPoint3 p) const;
  std::optional<Span> stretch(Seen a, Seen b) const;
  std::optional<FieldPoint3> frontAt(const Cylinder& shape, double height) const;

  FieldCamera camera_;
  double u_ = 0.0;              // x of the rays at depth 1
  FieldPoint3 normal_;          // of the plane, not normalised
  double inverseNormal_ = 1.0;  // 1 / length of the normal
};

}  // namespace kelpie::sim
