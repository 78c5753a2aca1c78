// SPDX-License-Identifier: Apache-2.0
// A motion file of any text. What is taken is in range, as is its mirror image, and the text that
// is written of it, with any words about it, is read again and written alike.
#include "robot/core/fields/FieldCheck.h"
#include "tests/fuzz/Input.h"
#include "tools/learn/motion/MotionFile.h"
#include "tools/learn/motion/MotionSpace.h"

namespace {

using namespace kelpie;
using fuzz::require;

void check(const actuator::MotionData& motion, const std::string& about) {
  std::string why;
  require(verify(motion, &why), "what is taken is in range: " + why);
  require(verify(learn::mirrored(motion), &why), "its mirror is in range: " + why);
  const std::string text = learn::motionText(motion, about);
  const fuzz::File written(fuzz::Bytes(text.begin(), text.end()), "-written.toml");
  const auto again = learn::readMotion(written.name());
  require(bool(again), "what is written is read: " + again.error() + "\n" + text);
  const std::string second = learn::motionText(*again, about);
  require(second == text, "and written alike:\n" + text + "\nthen\n" + second);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::File file(fuzz::Bytes(data, data + size), ".toml");
  const auto motion = learn::readMotion(file.name());
  if (motion) {
    check(*motion, std::string(data, data + size));
  } else {
    fuzz::requireLine(motion.error(), file.name());
  }
  return 0;
}
