// SPDX-License-Identifier: Apache-2.0
// The terminal while somebody drives: keys come one by one and unseen, picture and lines are drawn
// in a screen of their own. The object's end puts the terminal back as it was; only a kill that no
// program sees (signal 9) leaves it so. Without a picture it draws one line again and again, which
// any terminal can.
#pragma once

#include <termios.h>

#include <memory>
#include <string>

#include "robot/core/Expected.h"
#include "robot/core/types/Image.h"
#include "tools/teleop/Blocks.h"

namespace kelpie::teleop {

class Screen {
 public:
  // An error when standard input is no terminal. `why`, if given, gets the reason for which there
  // is no picture although one was wanted.
  static Expected<std::unique_ptr<Screen>> open(bool withPicture, std::string& why);
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  int input() const;  // descriptor to wait at
  // Appends what was typed, if anything; does not wait. False: the terminal is gone.
  bool read(std::string& typed) const;
  // `note` is the last thing that happened, for a line of its own. False: the terminal is gone.
  bool draw(const Image& image, const std::string& status, const std::string& note);

 private:
  Screen(const termios& before, bool picture) : before_(before), picture_(picture) {}
  std::string wholeScreen(const Image& image, const std::string& status, const std::string& note);
  std::string oneLine(const std::string& status);

  termios before_;
  bool picture_;
  TextSize last_;     // of the terminal when it was drawn last
  std::string text_;  // drawn last, without a picture
};

}  // namespace kelpie::teleop
