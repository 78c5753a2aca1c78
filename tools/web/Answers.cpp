// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "robot/core/NumberText.h"
#include "tools/web/Site.h"

namespace kelpie::web {
namespace {

namespace fs = std::filesystem;

struct Part {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};

// A range in another unit is not looked at (RFC 9110, 14.2).
constexpr std::string_view kUnit = "bytes=";
bool isInBytes(const std::string& range) { return range.compare(0, kUnit.size(), kUnit) == 0; }

// "bytes=0-99", "bytes=100-" or "bytes=-20" of a file of that size (RFC 9110, 14.1.2). Nothing for
// what is no such range or lies beyond the file.
std::optional<Part> partOf(const std::string& range, std::uint64_t size) {
  const auto dash = range.find('-');
  if (dash == std::string::npos || size == 0) return std::nullopt;
  const std::string from = range.substr(kUnit.size(), dash - kUnit.size());
  const std::string to = range.substr(dash + 1);
  const auto first = numberFrom<std::uint64_t>(from);
  const auto last = numberFrom<std::uint64_t>(to);
  if (from.empty() && last && *last > 0) return Part{size - std::min(size, *last), size - 1};
  if (!first || *first >= size || (!to.empty() && (!last || *last < *first))) return std::nullopt;
  return Part{*first, last ? std::min(*last, size - 1) : size - 1};
}

}  // namespace

Answer textAnswer(unsigned status, std::string text) {
  Answer answer;
  answer.status = status;
  answer.text = std::move(text);
  return answer;
}

Answer fileAnswer(const Request& request, const std::string& path, const std::string& type) {
  std::error_code error;
  const std::uint64_t size = fs::file_size(path, error);
  if (error || !fs::is_regular_file(path, error)) return textAnswer(404, "there is no such file\n");
  Answer answer;
  answer.type = type;
  answer.file = path;
  answer.size = answer.count = size;
  if (!isInBytes(request.range)) return answer;
  const auto part = partOf(request.range, size);
  if (!part) {
    answer = textAnswer(416, "the range is not in the file\n");
    answer.size = size;
    return answer;
  }
  answer.status = 206;
  answer.first = part->first;
  answer.count = part->last - part->first + 1;
  return answer;
}

}  // namespace kelpie::web
