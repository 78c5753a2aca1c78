// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/JsonText.h"

#include <array>
#include <charconv>
#include <cmath>

namespace kelpie::cli {
namespace {

using Json = nlohmann::ordered_json;

// "3.0" and not "3": who reads it back shall get a float again.
void addNumber(double number, std::string& text) {
  if (!std::isfinite(number)) {
    text += "null";
    return;
  }
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  const std::string written(digits.data(), end);
  text += written;
  if (written.find_first_of(".e") == std::string::npos) text += ".0";
}

class Writer {
 public:
  explicit Writer(int indent) : indent_(indent) {}

  void add(const Json& value, int depth) {
    if (value.is_number_float()) return addNumber(value.get<double>(), text_);
    if (!value.is_structured() || value.empty()) {
      text_ += value.dump(-1, ' ', false, Json::error_handler_t::replace);
      return;
    }
    text_ += value.is_array() ? '[' : '{';
    bool first = true;
    for (const auto& item : value.items()) {
      if (!first) text_ += ',';
      first = false;
      newLine(depth + 1);
      if (value.is_object()) text_ += Json(item.key()).dump() + (indent_ < 0 ? ":" : ": ");
      add(item.value(), depth + 1);
    }
    newLine(depth);
    text_ += value.is_array() ? ']' : '}';
  }
  const std::string& text() const { return text_; }

 private:
  void newLine(int depth) {
    if (indent_ < 0) return;
    text_ += '\n';
    text_.append(static_cast<std::size_t>(indent_ * depth), ' ');
  }

  int indent_;
  std::string text_;
};

}  // namespace

std::string jsonText(const Json& value, int indent) {
  Writer writer(indent);
  writer.add(value, 0);
  return writer.text();
}

}  // namespace kelpie::cli
