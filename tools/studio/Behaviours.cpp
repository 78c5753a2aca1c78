// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/Behaviours.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tools/cli/WholeFile.h"

namespace kelpie::studio {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::vector<BehaviourFile> Behaviours::list() const {
  std::vector<BehaviourFile> files;
  for (const auto& [team, folder] : folders_) {
    std::error_code error;
    for (fs::recursive_directory_iterator i(folder, error), end; !error && i != end;
         i.increment(error))
      if (i->path().extension() == ".py" && i->is_regular_file(error) && !i->is_symlink(error))
        files.push_back({team, fs::relative(i->path(), folder, error).string()});
  }
  std::sort(files.begin(), files.end(), [](const BehaviourFile& a, const BehaviourFile& b) {
    return a.team != b.team ? a.team < b.team : a.path < b.path;
  });
  return files;
}

// Whatever a path says, only what the list holds is opened.
Expected<std::string> Behaviours::placeOf(const BehaviourFile& file) const {
  const auto known = list();
  const bool listed = std::any_of(known.begin(), known.end(), [&](const BehaviourFile& one) {
    return one.team == file.team && one.path == file.path;
  });
  if (!listed) return Error{"there is no such behaviour"};
  return (fs::path(folders_.at(file.team)) / file.path).string();
}

Expected<std::string> Behaviours::read(const BehaviourFile& file) const {
  const auto place = placeOf(file);
  if (!place) return place;
  std::ifstream in(*place, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) return Error{file.path + ": cannot be read"};
  return text;
}

Status Behaviours::write(const BehaviourFile& file, const std::string& text) const {
  const auto place = placeOf(file);
  if (!place) return Error{place.error()};
  if (!cli::writeWhole(*place, text)) return Error{file.path + ": cannot be written"};
  return Done{};
}

}  // namespace kelpie::studio
