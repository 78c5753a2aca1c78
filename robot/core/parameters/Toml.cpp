// SPDX-License-Identifier: Apache-2.0
#include "robot/core/parameters/Toml.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

namespace kelpie {
namespace {

Expected<std::string> fileText(const std::string& path) {
  std::error_code none;
  if (std::filesystem::is_directory(path, none)) return Error{path + ": is a directory"};
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad()) {
    return Error{path + ": " + (errno != 0 ? std::strerror(errno) : "cannot be read")};
  }
  return text;
}

// Behind the quoted text that begins at `at`; that of a single line ends with the line at the
// latest.
std::size_t behindQuoted(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool lines = text.substr(at, 3) == three;
  for (at += lines ? 3 : 1; at < text.size(); ++at) {
    if (text[at] == '\\' && quote == '"') {
      ++at;
    } else if (lines && text.substr(at, 3) == three) {
      at += 3;  // its last two quotes may stand before these
      return std::min(text.find_first_not_of(quote, at), at + 2);
    } else if (!lines && (text[at] == quote || text[at] == '\n')) {
      return at + 1;
    }
  }
  return text.size();
}

bool isBeyondAscii(char c) { return static_cast<unsigned char>(c) >= 0x80; }

// The first letter beyond ASCII behind a backslash and blanks, by which a quoted text of several
// lines goes on at its next word.
std::size_t letterThatGoesOn(std::string_view quoted) {
  if (quoted.substr(0, 3) != "\"\"\"") return std::string_view::npos;
  for (std::size_t at = quoted.find('\\'); at < quoted.size(); at = quoted.find('\\', at)) {
    const std::size_t next = quoted.find_first_not_of(" \t\r\n\v\f", at + 1);
    if (next != at + 1 && next < quoted.size() && isBeyondAscii(quoted[next])) return next;
    at += 2;  // what is behind a backslash is no backslash of its own
  }
  return std::string_view::npos;
}

// The first letter beyond ASCII of which toml++ 3.3 asks whether it is white space, in a switch
// that lacks most of them: neither in quotes nor in a comment, where none is right, or where a
// quoted text goes on.
std::size_t strayLetter(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::size_t at = text.substr(0, 3) == kByteOrderMark ? 3 : 0;
  while (at < text.size()) {
    if (text[at] == '#') {
      at = text.find('\n', at);
    } else if (text[at] == '"' || text[at] == '\'') {
      const std::size_t behind = behindQuoted(text, at);
      const std::size_t stray = letterThatGoesOn(text.substr(at, behind - at));
      if (stray != std::string_view::npos) return at + stray;
      at = behind;
    } else if (isBeyondAscii(text[at])) {
      return at;
    } else {
      ++at;
    }
  }
  return std::string_view::npos;
}

}  // namespace

Expected<toml::table> readToml(const std::string& path) {
  const Expected<std::string> text = fileText(path);
  if (!text) return Error{text.error()};
  const auto lineOf = [&](std::size_t line) { return path + ':' + std::to_string(line) + ": "; };
  const std::size_t stray = strayLetter(*text);
  if (stray != std::string::npos) {
    const auto end = text->begin() + static_cast<std::ptrdiff_t>(stray);
    const auto before = std::count(text->begin(), end, '\n');
    return Error{lineOf(1 + static_cast<std::size_t>(before)) +
                 "a letter beyond ASCII stands neither in quotes nor in a comment, or behind a "
                 "backslash and blanks"};
  }
  toml::parse_result parsed = toml::parse(*text, path);
  if (parsed) return std::move(parsed).table();
  const toml::parse_error& error = parsed.error();
  return inOneLine(lineOf(error.source().begin.line) + std::string(error.description()));
}

Error inOneLine(std::string error) {
  const auto isControl = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
  std::replace_if(error.begin(), error.end(), isControl, ' ');
  return Error{std::move(error)};
}

}  // namespace kelpie
