// SPDX-License-Identifier: Apache-2.0
#include "tools/web/Target.h"

#include <sstream>

namespace kelpie::web {
namespace {

int digitOf(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

}  // namespace

std::string decoded(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool triple = text[i] == '%' && i + 2 < text.size() && digitOf(text[i + 1]) >= 0 &&
                        digitOf(text[i + 2]) >= 0;
    out += triple ? static_cast<char>(16 * digitOf(text[i + 1]) + digitOf(text[i + 2])) : text[i];
    if (triple) i += 2;
  }
  return out;
}

void readTarget(const std::string& target, Request& request) {
  const auto mark = target.find('?');
  request.path = decoded(target.substr(0, mark));
  if (mark == std::string::npos) return;
  std::istringstream words(target.substr(mark + 1));
  for (std::string word; std::getline(words, word, '&');) {
    const auto equals = word.find('=');
    const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
    request.query[decoded(word.substr(0, equals))] = decoded(value);
  }
}

}  // namespace kelpie::web
