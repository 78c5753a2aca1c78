// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "tools/live/Feed.h"

namespace kelpie::live {

Expected<std::unique_ptr<PlaybackFeed>> PlaybackFeed::open(const std::vector<std::string>& logs,
                                                           Hub& viewers, Hub& studio) {
  std::unique_ptr<PlaybackFeed> feed(new PlaybackFeed(viewers, studio));
  for (const std::string& path : logs) {
    auto reader = LogReader::open(path);
    if (!reader) return Error{reader.error()};
    auto source = std::make_unique<Source>(Source{std::move(*reader), feed->relay_.addLog(), {}});
    source->more = source->reader.next(source->message);
    if (!source->more) return Error{path + ": holds no messages"};
    feed->sources_.push_back(std::move(source));
  }
  if (feed->sources_.empty()) return Error{"there is no log to be played"};
  feed->first_ = feed->oldest()->message.time;
  return feed;
}

PlaybackFeed::Source* PlaybackFeed::oldest() {
  Source* best = nullptr;
  for (const auto& source : sources_)
    if (source->more && (best == nullptr || source->message.time < best->message.time))
      best = source.get();
  return best;
}

TimeUs PlaybackFeed::timeAt(Clock::time_point now) const {
  const auto gone = std::chrono::duration_cast<std::chrono::microseconds>(now - *start_);
  return {first_.us + gone.count()};
}

void PlaybackFeed::poll() {
  const auto now = Clock::now();
  if (!start_ && !viewers_.hasPeers() && !studio_.hasPeers()) return;
  if (!start_) start_ = now;
  const TimeUs due = timeAt(now);
  Source* next = oldest();
  for (; next != nullptr && !(due < next->message.time); next = oldest()) {
    const bool late = due.us - next->message.time.us > 500000;
    relay_.take(next->log, next->message, late);
    next->more = next->reader.next(next->message);
  }
  ended_ = next == nullptr;
}

}  // namespace kelpie::live
