// SPDX-License-Identifier: Apache-2.0
#include "tests/vision/Hostile.h"

#include <algorithm>
#include <cmath>

#include "robot/body/Camera.h"
#include "tests/core/RandomValue.h"
#include "tests/vision/Painting.h"
#include "vision/pixels/PlaneImage.h"

namespace kelpie::vision {
namespace {

Yuv colourOf(ColourClass c) { return kPlaneColours[index(c)]; }

Yuv anyClass(Random& random) {
  return kPlaneColours[random.index(static_cast<std::uint32_t>(kColourClassCount))];
}

// One of those that form blobs.
Yuv anyObject(Random& random) { return kPlaneColours[1 + random.index(4)]; }

int within(Random& random, int low, int high) {
  return low + static_cast<int>(random.index(static_cast<std::uint32_t>(high - low) + 1));
}

// Colours each pixel with what `colour(x, y)` says.
template <class Colour>
void fill(Image& image, Colour colour) {
  for (int y = 0; y < kImageHeight; ++y)
    for (int x = 0; x < kImageWidth; ++x) image.set(x, y, colour(x, y));
}

void drawNoise(Random& random, Image& image) {
  const auto byte = [&random] { return static_cast<std::uint8_t>(random.index(256)); };
  fill(image, [&](int, int) { return Yuv{byte(), byte(), byte()}; });
}

void drawDisc(Image& image, int cx, int cy, int radius, Yuv colour) {
  for (int y = std::max(0, cy - radius); y < std::min(kImageHeight, cy + radius); ++y)
    for (int x = std::max(0, cx - radius); x < std::min(kImageWidth, cx + radius); ++x)
      if ((x - cx) * (x - cx) + (y - cy) * (y - cy) <= radius * radius) image.set(x, y, colour);
}

void drawBox(Image& image, int left, int top, int width, int height, Yuv colour) {
  for (int y = std::max(0, top); y < std::min(kImageHeight, top + height); ++y)
    for (int x = std::max(0, left); x < std::min(kImageWidth, left + width); ++x)
      image.set(x, y, colour);
}

void drawPatches(Random& random, Image& image) {
  const Yuv ground = random.chance(0.7) ? colourOf(ColourClass::green) : anyClass(random);
  fill(image, [&](int, int) { return ground; });
  for (int left = within(random, 1, 120); left > 0; --left) {
    const int x = within(random, -10, kImageWidth);
    const int y = within(random, -10, kImageHeight);
    const int size = within(random, 1, random.chance(0.2) ? 80 : 16);
    const Yuv colour = random.chance(0.7) ? anyObject(random) : anyClass(random);
    if (random.chance(0.5))
      drawDisc(image, x, y, size, colour);
    else
      drawBox(image, x, y, size, within(random, 1, 30), colour);
  }
}

void drawStripes(Random& random, Image& image) {
  std::array<Yuv, 4> colours;
  for (auto& c : colours) c = random.chance(0.7) ? anyObject(random) : anyClass(random);
  const int width = within(random, 1, 20);
  const int dx = within(random, -2, 2);
  const int dy = dx == 0 ? 1 : within(random, -2, 2);
  fill(image, [&](int x, int y) {
    return colours[static_cast<std::size_t>((dx * x + dy * y + 1000) / width) % 4];
  });
}

void drawChess(Random& random, Image& image) {
  const int cell = within(random, 1, 8);
  const Yuv a = anyObject(random);
  const Yuv b = random.chance(0.5) ? anyObject(random) : anyClass(random);
  fill(image, [&](int x, int y) { return (x / cell + y / cell) % 2 == 0 ? a : b; });
}

void drawBeacons(Random& random, Image& image) {
  const int width = within(random, 3, 24);
  const int band = within(random, 3, 24);
  const int gap = within(random, 0, 8);
  fill(image, [](int, int) { return colourOf(ColourClass::green); });
  for (int y = within(random, 0, band); y < kImageHeight; y += 3 * band + gap)
    for (int x = within(random, 0, width); x < kImageWidth; x += width + gap) {
      const Yuv partner = colourOf(random.chance(0.5) ? ColourClass::blue : ColourClass::yellow);
      const bool pinkBelow = random.chance(0.5);
      drawBox(image, x, y, width, band, pinkBelow ? partner : colourOf(ColourClass::pink));
      drawBox(image, x, y + band, width, band, pinkBelow ? colourOf(ColourClass::pink) : partner);
      drawBox(image, x, y + 2 * band, width, band, colourOf(ColourClass::white));
    }
}

void drawBalls(Random& random, Image& image) {
  const int radius = within(random, 1, 30);
  const int step = 2 * radius + within(random, 1, 6);
  fill(image, [](int, int) { return colourOf(ColourClass::green); });
  for (int y = radius; y < kImageHeight; y += step)
    for (int x = radius; x < kImageWidth; x += step)
      drawDisc(image, x, y, radius, colourOf(ColourClass::orange));
}

std::unique_ptr<Image> paintedScene(int number) {
  Painting p;
  p.carpetEnd = 230;
  p.noise = 3.0;
  p.lineAt = 90 + 20 * number;
  p.balls.push_back({20.0 - 10.0 * number, 60.0 + 40.0 * number});
  p.beacons.push_back({{-60, 200}, kBluePaint, kPinkPaint});
  addGoal(p, 20, 200, number == 0 ? kYellowPaint : kBluePaint);
  auto image = std::make_unique<Image>();
  paint(p, cameraAt(16, 5.0 * number, -5.0 - 5.0 * number), *image);
  return image;
}

// Blocks of any class, of the image itself shifted, or of noise.
void drawBlocks(Random& random, Image& image) {
  for (int left = within(random, 1, 30); left > 0; --left) {
    const int width = within(random, 2, 60);
    const int height = within(random, 2, 60);
    const int x0 = within(random, 0, kImageWidth - width);
    const int y0 = within(random, 0, kImageHeight - height);
    const int shift = within(random, -y0, kImageHeight - height - y0);
    const auto kind = random.index(3);
    const Yuv colour = anyClass(random);
    const auto byte = [&random] { return static_cast<std::uint8_t>(random.index(256)); };
    for (int y = y0; y < y0 + height; ++y)
      for (int x = x0; x < x0 + width; ++x)
        image.set(x, y,
                  kind == 0   ? colour
                  : kind == 1 ? image.pixel(x, y + shift)
                              : Yuv{byte(), byte(), byte()});
  }
}

double angleFrom(std::uint8_t byte) { return (byte - 128.0) * 180.0 / 128.0; }

}  // namespace

HostileFrames::HostileFrames(std::uint64_t seed) : random_(seed) {}

void HostileFrames::drawImage(HostileKind kind, Image& image) {
  switch (kind) {
    case HostileKind::noise: return drawNoise(random_, image);
    case HostileKind::patches: return drawPatches(random_, image);
    case HostileKind::stripes: return drawStripes(random_, image);
    case HostileKind::chess: return drawChess(random_, image);
    case HostileKind::beacons: return drawBeacons(random_, image);
    case HostileKind::balls: return drawBalls(random_, image);
    case HostileKind::scene:
      while (scenes_.size() < 2) scenes_.push_back(paintedScene(static_cast<int>(scenes_.size())));
      image = *scenes_[random_.index(static_cast<std::uint32_t>(scenes_.size()))];
      return drawBlocks(random_, image);
    case HostileKind::oneColour: break;
  }
  const Yuv colour = anyClass(random_);
  fill(image, [&](int, int) { return colour; });
}

void HostileFrames::takePosture(HostileFrame& frame) {
  if (random_.chance(0.5)) {
    randomise(frame.input.sensors, random_);
    randomise(frame.input.headRate, random_);
    randomise(frame.input.stance, random_);
    randomise(frame.input.odometry, random_);
    if (random_.chance(0.7)) frame.input.headRate = {};  // fast heads switch lines off
    frame.body = body::step(frame.input, {});
    return;
  }
  frame.body = bodyOf(cameraAt(random_.uniform(0.5, 60), random_.uniform(-180, 180),
                               random_.uniform(-90, 90), random_.uniform(-180, 180)));
  if (random_.chance(0.3))
    frame.body.horizon = {random_.uniform(-1e4, 1e4), random_.uniform(-1e4, 1e4)};
  frame.body.headSpeed = random_.chance(0.3) ? random_.uniform(0, 10) : 0.0;
}

void HostileFrames::make(HostileKind kind, HostileFrame& frame) {
  drawImage(kind, frame.input.image);
  takePosture(frame);
}

void frameFromBytes(const std::uint8_t* data, std::size_t size, HostileFrame& frame) {
  std::size_t at = 0;
  const auto next = [&] { return size == 0 ? std::uint8_t{0} : data[at++ % size]; };
  frame.input = {};
  for (const Joint joint : {Joint::neckTilt, Joint::headPan, Joint::headNod})
    frame.input.sensors.joints[joint] = Angle::deg(angleFrom(next()));
  frame.input.stance = {next() * 30.0 / 255.0, Angle::deg(0.5 * angleFrom(next())), {}};
  frame.input.headRate = {0.0, (next() - 128.0) / 4.0, (next() - 128.0) / 4.0};
  frame.input.odometry.turn = Angle::deg(angleFrom(next()));
  frame.body = body::step(frame.input, {});
  const std::uint32_t noise = next() % 32U + 1U;
  Random random(noise);
  for (std::size_t pixel = 0; pixel < kImagePixels;) {
    const Yuv colour = kPlaneColours[next() % kColourClassCount];
    for (int left = 1 + next(); left > 0 && pixel < kImagePixels; --left, ++pixel) {
      frame.input.image.y[pixel] = static_cast<std::uint8_t>(colour.y + random.index(noise));
      frame.input.image.cr[pixel] = static_cast<std::uint8_t>(colour.cr + random.index(noise));
      frame.input.image.cb[pixel] = static_cast<std::uint8_t>(colour.cb + random.index(noise));
    }
  }
}

}  // namespace kelpie::vision
