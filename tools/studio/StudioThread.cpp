// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/StudioThread.h"

#include <utility>

namespace kelpie::studio {

Expected<std::unique_ptr<StudioThread>> StudioThread::begin(const StudioOptions& options) {
  auto studio = Studio::open(options);
  if (!studio) return Error{studio.error()};
  return std::unique_ptr<StudioThread>(new StudioThread(std::move(*studio)));
}

StudioThread::StudioThread(std::unique_ptr<Studio> studio) : studio_(std::move(studio)) {
  thread_ = std::thread([this] { studio_->run([this] { return over_.load(); }); });
}

StudioThread::~StudioThread() {
  over_ = true;
  thread_.join();
}

}  // namespace kelpie::studio
