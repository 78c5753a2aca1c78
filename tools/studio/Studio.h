// SPDX-License-Identifier: Apache-2.0
// The studio as a server: recorded logs, a match that is being played, or recorded logs played by
// the clock, for its own page and for viewers that speak Foxglove's protocol. Serves from the
// thread that calls run(), with less right to the processor than a match.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robot/core/Expected.h"
#include "tools/studio/MatchLink.h"
#include "tools/web/Server.h"

namespace kelpie::studio {

struct StudioOptions {
  web::ServerParams web;
  std::vector<std::string> logs;    // files, and folders of them
  std::string folder;               // where a match is played or will be; empty: none
  bool byTheClock = false;          // the logs are played to viewers, as a match would be
  std::shared_ptr<MatchLink> link;  // of a match that obeys
  std::map<std::string, std::string> behaviours;  // folders, by team
};

class Studio {
 public:
  static Expected<std::unique_ptr<Studio>> open(const StudioOptions& options);
  ~Studio();
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  std::string url() const;
  // With `byTheClock`: whether the logs have been played to their end.
  bool played() const;
  // Until `over` says so, which is asked a hundred times a second.
  void run(const std::function<bool()>& over);

 private:
  struct Parts;
  explicit Studio(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace kelpie::studio
