// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/Studio.h"

#include <sys/resource.h>

#include <filesystem>
#include <optional>
#include <utility>

#include "tools/cli/DataFolder.h"
#include "tools/cli/JsonText.h"
#include "tools/cli/Version.h"
#include "tools/live/Feed.h"
#include "tools/session/MatchFolder.h"
#include "tools/studio/Site.h"

namespace kelpie::studio {
namespace {

constexpr double kPollEvery = 0.01;  // s
constexpr int kNice = 10;            // of the serving thread: a match on all cores loses nothing
constexpr const char* kLineTopic = "/live/log";

}  // namespace

struct Studio::Parts {
  StudioOptions options;
  LogShelf shelf;
  live::Hub viewers;
  live::Hub studio;
  live::FolderFeed* folder = nullptr;      // the feed, if it is one
  live::PlaybackFeed* playback = nullptr;  // so
  std::unique_ptr<live::Feed> feed;
  std::unique_ptr<Site> site;
  std::optional<web::Server> server;
  bool wasPlaying = false;

  explicit Parts(const StudioOptions& from)
      : options(from),
        viewers("kelpie", live::wallTime().us),
        studio("kelpie studio", live::wallTime().us) {}

  Status begin();
  Status beginFeed();
  void poll();
  void passLines();
  void shelveWhatWasPlayed();
};

Status Studio::Parts::beginFeed() {
  if (!options.folder.empty()) {
    auto following = std::make_unique<live::FolderFeed>(
        options.folder, viewers, studio, [this] { return cli::isPlayedIn(options.folder); });
    folder = following.get();
    feed = std::move(following);
  }
  if (!options.byTheClock) return Done{};
  auto opened = live::PlaybackFeed::open(options.logs, viewers, studio);
  if (!opened) return Error{opened.error()};
  playback = opened->get();
  feed = std::move(*opened);
  return Done{};
}

Status Studio::Parts::begin() {
  for (const std::string& log : options.logs) {
    std::error_code error;
    const bool match = std::filesystem::is_directory(log, error) && !cli::isPlayedIn(log);
    const Status added = match ? shelf.addMatch(log) : shelf.add(log);
    if (!added) return added;
  }
  const Status feeding = beginFeed();
  if (!feeding) return feeding;
  const auto playing = [this] { return folder == nullptr ? feed != nullptr : folder->playing(); };
  const std::string title = options.byTheClock ? "recorded logs" : options.folder;
  site = std::make_unique<Site>(SiteParts{cli::dataFolder() + "/build/studio/page",
                                          cli::versionLine(), title, shelf, viewers, studio,
                                          options.link, Behaviours(options.behaviours), playing});
  auto opened = web::Server::open(options.web, *site);
  if (!opened) return Error{opened.error()};
  server.emplace(std::move(*opened));
  return Done{};
}

void Studio::Parts::passLines() {
  if (!options.link) return;
  for (const std::string& line : options.link->takeLines()) {
    const std::string text = cli::jsonText({{"line", line}});
    studio.offer(kLineTopic, {"kelpie.Line", "jsonschema", "{}", "json"}, true);
    studio.publish(kLineTopic, live::wallTime(), text.data(), text.size());
    viewers.say(line);
  }
}

// Its logs are joined in the folder now, or still parts if it was killed.
void Studio::Parts::shelveWhatWasPlayed() {
  shelf.clear();
  const Status added = shelf.addMatch(options.folder);
  if (!added) viewers.say(added.error());
}

void Studio::Parts::poll() {
  if (feed) feed->poll();
  passLines();
  const bool playing = folder != nullptr && folder->playing();
  if (wasPlaying && !playing) shelveWhatWasPlayed();
  wasPlaying = playing;
}

Studio::Studio(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Studio::~Studio() = default;

Expected<std::unique_ptr<Studio>> Studio::open(const StudioOptions& options) {
  auto parts = std::make_unique<Parts>(options);
  const Status begun = parts->begin();
  if (!begun) return Error{begun.error()};
  return std::unique_ptr<Studio>(new Studio(std::move(parts)));
}

std::string Studio::url() const { return parts_->server->url(); }

bool Studio::played() const { return parts_->playback != nullptr && parts_->playback->ended(); }

void Studio::run(const std::function<bool()>& over) {
  (void)setpriority(PRIO_PROCESS, 0, kNice);  // Linux: of this thread alone
  parts_->server->run(kPollEvery, [&] {
    parts_->poll();
    if (over()) parts_->server->stop();
  });
}

}  // namespace kelpie::studio
