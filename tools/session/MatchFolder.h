// SPDX-License-Identifier: Apache-2.0
// The folder that a match is kept in. While it is played each process writes its own log into the
// folder's `playing`; at the end they are joined into match.mcap, red-1.mcap, ... What an earlier
// match left is moved to `earlier/1`, `earlier/2`, ..., so that nothing is lost, and a match that
// was killed keeps its `playing` there, for joinParts(). Fails where the folder cannot be made or
// written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/cli/log/Logs.h"

namespace kelpie::cli {

class MatchFolder {
 public:
  // `wanted`, or `wanted-2`, ... while a match is played there. Held until the object goes. `stem`
  // names its log: match.mcap, or teleop.mcap of a drive, beside which a match may stay.
  static Expected<MatchFolder> take(const std::string& wanted, const std::string& stem = "match");
  MatchFolder(MatchFolder&& other) noexcept;
  MatchFolder& operator=(MatchFolder&&) = delete;
  ~MatchFolder();

  const std::string& path() const { return path_; }
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  std::string playing() const { return file("playing"); }
  // What a person should know of: another match is played there, one that was killed was moved.
  const std::vector<std::string>& notes() const { return notes_; }

  // Moves the files of the match before away: there is another now.
  Status moveEarlier();
  // Of those in `earlier` whose logs were joined, removes all but the newest.
  void forgetAllBut(int newest);

 private:
  MatchFolder() = default;
  Status begin();
  Status keepKilled();
  Status moveOlderThan(std::filesystem::file_time_type time);
  bool isOurs(const std::string& name) const;
  void removeHalves() const;
  Expected<std::string> placeForEarlier();

  std::string path_;
  std::string stem_;
  std::string earlier_;  // place of the match before, once something was moved there
  int lock_ = -1;        // file descriptor of the folder
  std::vector<std::string> notes_;
};

// Whether a match is being played in the folder.
bool isPlayedIn(const std::string& folder);

struct JoinedLog {
  std::string path;
  Joined holds;
};

// Joins each robot's log in FOLDER/playing with the world's into FOLDER, and removes `playing` when
// all are joined. An error leaves all parts as they are.
Expected<std::vector<JoinedLog>> joinParts(const std::string& folder);
// The same of a match in which nobody logged the watched robot: its log is the world's alone.
Expected<std::vector<JoinedLog>> joinWithoutWatched(const std::string& folder,
                                                    const std::string& log);
// Removes `playing`, of a match that never began.
void forgetParts(const std::string& folder);

}  // namespace kelpie::cli
