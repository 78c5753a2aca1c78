// SPDX-License-Identifier: Apache-2.0
// A message's type as files and viewers describe it: its name, and the definition of all that it is
// made of, so that whoever reads it needs nothing of ours.
#pragma once

#include <google/protobuf/descriptor.h>

#include "robot/core/log/LogWriter.h"

namespace kelpie::viewer {

ReadyType readyTypeOf(const google::protobuf::Descriptor& type);

}  // namespace kelpie::viewer
