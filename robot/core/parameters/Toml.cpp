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

std::string_view withoutByteOrderMark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return text.substr(0, kMark.size()) == kMark ? text.substr(kMark.size()) : text;
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

// The first letter beyond ASCII behind a backslash, or behind the blanks after one, by which a
// quoted text of several lines goes on at its next word.
std::size_t letterThatGoesOn(std::string_view quoted) {
  if (quoted.substr(0, 3) != "\"\"\"") return std::string_view::npos;
  for (std::size_t at = quoted.find('\\'); at < quoted.size(); at = quoted.find('\\', at)) {
    const std::size_t next = quoted.find_first_not_of(" \t\r\n\v\f", at + 1);
    if (next < quoted.size() && isBeyondAscii(quoted[next])) return next;
    at += 2;  // what is behind a backslash is no backslash of its own
  }
  return std::string_view::npos;
}

// The first letter beyond ASCII of which toml++ 3.3 asks whether it is white space, in a switch
// that lacks most of them: neither in quotes nor in a comment, where none is right, or where a
// quoted text goes on.
std::size_t strayLetter(std::string_view text) {
  std::size_t at = 0;
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

// The same text with other letters in place of those beyond ASCII, as many different ones.
std::string inAscii(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (isBeyondAscii(c))
      out += {'x', kDigits[byte / kDigits.size()], kDigits[byte % kDigits.size()]};
    else
      out += c;
  }
  return out;
}

Expected<toml::table> parsed(std::string_view text, const std::string& path) {
  toml::parse_result result = toml::parse(text, path);
  if (result) return std::move(result).table();
  const toml::parse_error& error = result.error();
  return inOneLine(path + ':' + std::to_string(error.source().begin.line) + ": " +
                   std::string(error.description()));
}

}  // namespace

Expected<toml::table> readToml(const std::string& path) {
  const Expected<std::string> text = fileText(path);
  if (!text) return Error{text.error()};
  const std::string_view body = withoutByteOrderMark(*text);
  if (std::none_of(body.begin(), body.end(), isBeyondAscii)) return parsed(body, path);
  const std::size_t stray = strayLetter(body);
  if (stray != std::string::npos) {
    const auto end = body.begin() + static_cast<std::ptrdiff_t>(stray);
    return Error{path + ':' + std::to_string(1 + std::count(body.begin(), end, '\n')) +
                 ": a letter beyond ASCII stands neither in quotes nor in a comment, or behind a "
                 "backslash"};
  }
  // Where quotes begin and end is known of sound files only.
  const Expected<toml::table> sound = parsed(inAscii(body), path);
  return sound ? parsed(body, path) : Error{sound.error()};
}

Error inOneLine(std::string error) {
  const auto isControl = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
  std::replace_if(error.begin(), error.end(), isControl, ' ');
  return Error{std::move(error)};
}

}  // namespace kelpie
