// SPDX-License-Identifier: Apache-2.0
// `kelpie new-team DIR`: a folder of behaviours that play at once, to be changed: what
// examples/team holds, and for its test the stand-in of this program's module `kelpie`. An
// existing folder is taken only when it is empty, and is empty again when something fails.
#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "behaviour/views/KelpieModule.h"
#include "tools/cli/Commands.h"
#include "tools/cli/DataFolder.h"
#include "tools/cli/WholeFile.h"

namespace kelpie::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPlaceholder = "DIR";  // of the folder's name, in README.md

std::string nameOf(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();  // of "." and "team/" too
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

// The page's commands name this folder.
Status writePage(const fs::path& page, const std::string& name) {
  std::ifstream file(page);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::string_view placeholder = kPlaceholder;
  for (auto at = text.find(placeholder); at != std::string::npos;
       at = text.find(placeholder, at + name.size()))
    text.replace(at, placeholder.size(), name);
  if (!writeWhole(page.string(), text)) return Error{page.string() + ": cannot be written"};
  return Done{};
}

Status fill(const fs::path& folder) {
  std::error_code error;
  const fs::path from = dataFolder() + "/examples/team";
  if (!fs::is_directory(from, error)) return Error{from.string() + ": does not exist"};
  fs::create_directories(folder, error);
  if (!error) fs::copy(from, folder, fs::copy_options::recursive, error);
  if (error) return Error{fmt::format("{}: {}", folder.string(), error.message())};
  const Status page = writePage(folder / "README.md", nameOf(folder));
  if (!page) return page;
  const std::string standIn = (folder / "test/kelpie.py").string();
  if (!writeWhole(standIn, behaviour::kelpieStandInText()))
    return Error{standIn + ": cannot be written"};
  return Done{};
}

// Leaves an empty folder, or none, as it was.
void undo(const fs::path& folder, bool wasThere) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    fs::remove_all(entry.path(), ignored);
  if (!wasThere) fs::remove(folder, ignored);
}

int newTeam(const std::string& folder) {
  std::error_code error;
  const bool wasThere = fs::exists(fs::symlink_status(folder, error));
  if (wasThere && !(fs::is_directory(folder, error) && fs::is_empty(folder, error)))
    return fail(folder + ": is there already, and no empty folder", kExitBadInput);
  const Status filled = fill(folder);
  if (!filled) undo(folder, wasThere);
  if (!filled) return fail(filled.error(), kExitMachine);
  fmt::print(
      "{0}/main.py: walks to the ball and kicks it; yours to change\n"
      "{0}/README.md: what next\n"
      "kelpie play --pycode {0}: plays it\n",
      folder);
  return kExitDone;
}

}  // namespace

void addNewTeam(CommandLine& app, int& code) {
  auto command = app.subcommand("new-team", "A folder of a team of your own, which plays at once");
  auto folder = std::make_shared<std::string>();
  command.option("DIR", *folder, "The folder to make: new, or empty").required().check(notEmpty());
  command.callback([folder, &code] { code = newTeam(*folder); });
}

}  // namespace kelpie::cli
