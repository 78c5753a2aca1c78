// SPDX-License-Identifier: Apache-2.0
#include "tools/teleop/Screen.h"

#include <fmt/core.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "tools/teleop/Keys.h"

namespace kelpie::teleop {
namespace {

constexpr const char* kEnter = "\033[?1049h\033[?25l\033[2J";  // other screen, no cursor, cleared
constexpr const char* kLeave = "\033[0m\033[?25h\033[?1049l";
constexpr TextSize kUsual{80, 24};

// False: nobody takes it any more.
bool writeAll(const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t put = write(STDOUT_FILENO, text.data() + done, text.size() - done);
    if (put >= 0) {
      done += static_cast<std::size_t>(put);
    } else if (errno == EAGAIN) {
      pollfd room{STDOUT_FILENO, POLLOUT, 0};
      poll(&room, 1, 100);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

TextSize terminalSize() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0)
    return kUsual;
  return {size.ws_col, size.ws_row};
}

// Why there can be no picture, or nothing.
std::string noPicture() {
  const char* kind = std::getenv("TERM");
  if (isatty(STDOUT_FILENO) == 0) return "standard output is no terminal";
  if (kind == nullptr || *kind == '\0') return "TERM is not set";
  return std::strcmp(kind, "dumb") == 0 ? "TERM is dumb" : "";
}

// Keys one by one and unseen. Ctrl-C still interrupts; what would stop or kill the program without
// a word does nothing.
termios forKeys(termios mode) {
  mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | IEXTEN);
  mode.c_iflag &= ~static_cast<tcflag_t>(IXON);
  mode.c_cc[VMIN] = 0;
  mode.c_cc[VTIME] = 0;
  mode.c_cc[VQUIT] = _POSIX_VDISABLE;
  mode.c_cc[VSUSP] = _POSIX_VDISABLE;
  return mode;
}

std::string at(int row) { return fmt::format("\033[{};1H", row); }

std::string cut(const std::string& text, int columns) {
  return text.substr(0, static_cast<std::size_t>(std::max(0, columns)));
}

}  // namespace

Expected<std::unique_ptr<Screen>> Screen::open(bool withPicture, std::string& why) {
  termios before{};
  if (tcgetattr(STDIN_FILENO, &before) != 0)
    return Error{"standard input is no terminal; --keys FILE drives without one"};
  if (withPicture) why = noPicture();
  const termios keys = forKeys(before);
  if (tcsetattr(STDIN_FILENO, TCSANOW, &keys) != 0)
    return Error{std::string("cannot set the terminal: ") + std::strerror(errno)};
  std::unique_ptr<Screen> screen(new Screen(before, withPicture && why.empty()));
  if (screen->picture_) writeAll(kEnter);
  return screen;
}

Screen::~Screen() {
  writeAll(picture_ ? kLeave : "\r\n");
  tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

int Screen::input() const { return STDIN_FILENO; }

// Where nothing has been typed a read gives no bytes either, as at the terminal's end: asked for
// before it, an end is there to be read and an empty line is not.
bool Screen::read(std::string& typed) const {
  pollfd keys{STDIN_FILENO, POLLIN, 0};
  if (poll(&keys, 1, 0) <= 0) return true;
  char buffer[256];
  const ssize_t got = ::read(STDIN_FILENO, buffer, sizeof buffer);
  if (got > 0) typed.append(buffer, static_cast<std::size_t>(got));
  return got > 0 || (got < 0 && (errno == EINTR || errno == EAGAIN));
}

bool Screen::draw(const Image& image, const std::string& status, const std::string& note) {
  return writeAll(picture_ ? wholeScreen(image, status, note) : oneLine(status));
}

std::string Screen::wholeScreen(const Image& image, const std::string& status,
                                const std::string& note) {
  const TextSize now = terminalSize();
  std::vector<std::string> below = {status};
  for (std::string& help : keyHelp()) below.push_back(std::move(help));
  below.push_back(note);
  const int spare = now.rows - static_cast<int>(below.size());
  const TextSize size = pictureSize({now.columns, spare});
  if (size.rows == 0) below.insert(below.begin() + 1, "(too small for a picture)");
  const bool changed = now.columns != last_.columns || now.rows != last_.rows;
  last_ = now;
  std::string text = changed ? "\033[2J" : "";
  int row = 0;
  if (size.rows > 0)
    for (const auto& line : blocksOf(image, size)) text += at(++row) + line;
  // Nothing is written in the last column: behind it some terminals would erase what is in it.
  for (const auto& line : below)
    if (row < now.rows) text += at(++row) + cut(line, now.columns - 1) + "\033[K";
  return text;
}

std::string Screen::oneLine(const std::string& status) {
  const std::string text = cut(status, terminalSize().columns - 1);
  const std::size_t before = text_.size();
  text_ = text;
  return "\r" + text + std::string(before > text.size() ? before - text.size() : 0, ' ');
}

}  // namespace kelpie::teleop
