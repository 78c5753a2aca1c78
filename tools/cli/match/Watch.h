// SPDX-License-Identifier: Apache-2.0
// A match that people watch while it is played: its folder served by a thread of its own, for the
// studio's page, whose user may also order the match about, and for viewers.
#pragma once

#include <memory>
#include <string>

#include "tools/cli/options/CommandLine.h"
#include "tools/session/Session.h"
#include "tools/studio/StudioThread.h"

namespace kelpie::cli {

struct WatchOptions {
  bool studio = false;  // the match goes by the clock and obeys
  bool live = false;    // viewers only; the match goes as fast as it can
  web::ServerParams web;

  bool any() const { return studio || live; }
};

void addWatchOptions(CommandLine& command, WatchOptions& options);
// What the session must do for it.
void prepareWatched(const WatchOptions& options, SessionOptions& session);

class Watch {
 public:
  // Serves from now on. `folder` is where the match is played.
  static Expected<std::unique_ptr<Watch>> begin(const WatchOptions& options,
                                                const SessionOptions& session,
                                                const std::string& folder);

  // Where people find it, a line for each way.
  std::vector<std::string> lines() const;
  // Lines for the user also go to the page, and the page's orders to the match.
  void listenTo(SessionTalk& talk);
  // The studio shows what was played until it is interrupted; viewers have seen it.
  void stay();

 private:
  Watch(const WatchOptions& options, std::shared_ptr<studio::MatchLink> link,
        std::unique_ptr<studio::StudioThread> studio);

  WatchOptions options_;
  std::shared_ptr<studio::MatchLink> link_;
  std::unique_ptr<studio::StudioThread> studio_;
};

}  // namespace kelpie::cli
