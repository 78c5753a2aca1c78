// SPDX-License-Identifier: Apache-2.0
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

#include "tools/live/Feed.h"
#include "tools/live/LogsOf.h"

namespace kelpie::live {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kLookEvery{200};  // for logs that are new
constexpr std::chrono::milliseconds kSlice{10};       // for one log at a time
constexpr std::uint64_t kLate = 1U << 19;  // bytes behind: five whole frames with their images

// Of a file or folder, as long as it is there; else 0.
std::uint64_t numberOf(const std::string& path) {
  struct stat info {};
  return stat(path.c_str(), &info) == 0 ? static_cast<std::uint64_t>(info.st_ino) : 0;
}

}  // namespace

FolderFeed::FolderFeed(std::string folder, Hub& viewers, Hub& studio, std::function<bool()> held)
    : folder_(std::move(folder)), viewers_(viewers), studio_(studio), held_(std::move(held)) {}

void FolderFeed::begin() {
  if (begunBefore_) viewers_.restart();
  if (begunBefore_) studio_.restart();
  begunBefore_ = playing_ = true;
  followers_.clear();
  known_.clear();
  relay_ = std::make_unique<Relay>(wallTime(), viewers_, studio_, kFramePause);
}

void FolderFeed::end() {
  playing_ = false;
  viewers_.say("the match is over");
  studio_.say("the match is over");
}

// A log is followed from its beginning as soon as it has one. One that was joined and removed is
// read to its end all the same. As long as one is open no other folder gets the number of its own.
void FolderFeed::look() {
  const std::string playing = (fs::path(folder_) / "playing").string();
  const std::uint64_t number = numberOf(playing);
  const bool played = number != 0 && (!held_ || held_());
  if (!played && playing_) end();
  if (!played) return;
  if (!playing_ || number != folderNumber_) begin();
  folderNumber_ = number;
  for (const std::string& path : logsOf(playing)) {
    if (known_.count(path) > 0) continue;
    auto tail = LogTail::open(path);
    if (!tail) continue;  // its first bytes are not written yet
    known_.insert(path);
    followers_.push_back({std::move(*tail), relay_->addLog()});
  }
}

void FolderFeed::poll() {
  const auto now = std::chrono::steady_clock::now();
  if (now >= nextLook_) {
    nextLook_ = now + kLookEvery;
    look();
  }
  for (Follower& follower : followers_) follow(follower);
}

// A log that grows faster than its messages are converted must keep neither others nor peers from
// their turn.
void FolderFeed::follow(Follower& follower) {
  const bool late = follower.tail.behind() > kLate;
  const auto end = std::chrono::steady_clock::now() + kSlice;
  LogMessage message;
  while (follower.tail.next(message)) {
    relay_->take(follower.log, message, late);
    if (std::chrono::steady_clock::now() > end) return;
  }
}

}  // namespace kelpie::live
