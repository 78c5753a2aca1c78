// SPDX-License-Identifier: Apache-2.0
// Messages for viewers in an MCAP file. The first error stays in status().
#pragma once

#include <map>
#include <utility>

#include "robot/core/log/LogWriter.h"
#include "tools/viewer/MessageSink.h"

namespace kelpie::viewer {

class ViewerFile : public MessageSink {
 public:
  static Expected<ViewerFile> create(const std::string& path);

  void take(const std::string& topic, TimeUs time,
            const google::protobuf::Message& message) override;
  std::size_t messages() const { return messages_; }
  Status status() const { return writer_.status(); }
  Status close() { return writer_.close(); }

 private:
  explicit ViewerFile(LogWriter writer) : writer_(std::move(writer)) {}

  LogWriter writer_;
  std::map<const google::protobuf::Descriptor*, ReadyType> types_;
  std::string bytes_;  // of the message being written
  std::size_t messages_ = 0;
};

}  // namespace kelpie::viewer
