// SPDX-License-Identifier: Apache-2.0
#include "behaviour/watch/HungScript.h"

#include <fcntl.h>
#include <internal/pycore_traceback.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <string_view>

namespace kelpie::behaviour {
namespace {

constexpr std::size_t kCapacity = 16U << 10U;  // of a traceback: 80 calls with their files
constexpr std::size_t kMaxOfLine = 100;        // of the script's text

// A text that is cut where its room ends.
class Text {
 public:
  void add(std::string_view part) {
    const std::size_t size = std::min(part.size(), bytes_.size() - size_);
    std::copy_n(part.begin(), size, bytes_.begin() + size_);
    size_ += size;
  }
  // All that comes from a file, or what there is room for.
  void read(int file) {
    for (ssize_t got = 1; got > 0; size_ += static_cast<std::size_t>(got)) {
      got = ::read(file, bytes_.data() + size_, bytes_.size() - size_);
      if (got < 0) return;
    }
  }
  std::string_view view() const { return {bytes_.data(), size_}; }
  // With an end for the C library.
  const char* path() {
    bytes_[std::min(size_, bytes_.size() - 1)] = '\0';
    return bytes_.data();
  }

 private:
  std::array<char, kCapacity> bytes_;
  std::size_t size_ = 0;
};

struct Place {
  std::string_view file;
  std::string_view line;
};

std::string_view between(std::string_view text, std::string_view begin, std::string_view end) {
  const std::size_t from = text.find(begin);
  if (from == std::string_view::npos) return {};
  text.remove_prefix(from + begin.size());
  return text.substr(0, text.find(end));
}

// Python's traceback for crashes, the innermost call first.
void readTraceback(PyThreadState* thread, Text& text) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_NONBLOCK | O_CLOEXEC) != 0) return;
  _Py_DumpTraceback(ends[1], thread);
  ::close(ends[1]);
  text.read(ends[0]);
  ::close(ends[0]);
}

// The innermost that is no code of the guard's.
Place placeIn(std::string_view traceback) {
  constexpr std::string_view kFile = "File \"";
  for (std::size_t at = traceback.find(kFile); at != std::string_view::npos;
       at = traceback.find(kFile, at + 1)) {
    const std::string_view row = traceback.substr(at, traceback.find('\n', at) - at);
    const Place place{between(row, kFile, "\", line "), between(row, "\", line ", " in ")};
    if (place.file != "<guard>") return place;
  }
  return {};
}

// The text of that line of a file, without what stands before and behind it.
std::string_view lineOf(std::string_view text, int number) {
  for (; number > 1 && !text.empty(); --number) {
    const std::size_t end = text.find('\n');
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  text = text.substr(0, text.find('\n'));
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == std::string_view::npos ? std::string_view{} : text.substr(begin, kMaxOfLine);
}

void addSource(const Place& place, Text& line) {
  Text path, number, source;
  path.add(place.file);
  number.add(place.line);
  const int file = ::open(path.path(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;  // in a zip
  source.read(file);
  ::close(file);
  const std::string_view text = lineOf(source.view(), std::atoi(number.path()));
  if (text.empty()) return;
  line.add(": ");
  line.add(text);
}

}  // namespace

void endHung(PyThreadState* thread, int exitCode) {
  Text traceback, line;
  readTraceback(thread, traceback);
  const Place place = placeIn(traceback.view());
  line.add("behaviour: ");
  if (!place.file.empty()) {
    line.add(place.file);
    line.add(":");
    line.add(place.line);
    line.add(": ");
  }
  line.add("it does not end and cannot be broken off, so that this process ends");
  if (!place.file.empty()) addSource(place, line);
  line.add("\n");
  (void)!::write(STDERR_FILENO, line.view().data(), line.view().size());
  ::_exit(exitCode);
}

}  // namespace kelpie::behaviour
