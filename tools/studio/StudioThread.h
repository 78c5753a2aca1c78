// SPDX-License-Identifier: Apache-2.0
// A studio that serves from a thread of its own for as long as the object lives.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "tools/studio/Studio.h"

namespace kelpie::studio {

class StudioThread {
 public:
  static Expected<std::unique_ptr<StudioThread>> begin(const StudioOptions& options);
  ~StudioThread();
  StudioThread(const StudioThread&) = delete;
  StudioThread& operator=(const StudioThread&) = delete;

  std::string url() const { return studio_->url(); }

 private:
  explicit StudioThread(std::unique_ptr<Studio> studio);

  std::unique_ptr<Studio> studio_;
  std::atomic<bool> over_{false};
  std::thread thread_;
};

}  // namespace kelpie::studio
