// SPDX-License-Identifier: Apache-2.0
// Where messages for viewers go: into a file, or to who watches a match.
#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "robot/core/Time.h"

namespace kelpie::viewer {

class MessageSink {
 public:
  virtual ~MessageSink() = default;
  // Of a topic all messages are of one type.
  virtual void take(const std::string& topic, TimeUs time,
                    const google::protobuf::Message& message) = 0;
};

}  // namespace kelpie::viewer
