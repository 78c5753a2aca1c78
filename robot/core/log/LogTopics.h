// SPDX-License-Identifier: Apache-2.0
// Topics of an agent's log.
#pragma once

namespace kelpie {

constexpr const char* kConfigTopic = "/config";
constexpr const char* kFrameInputTopic = "/frame/input";
constexpr const char* kPlaneFrameTopic = "/frame/plane";      // in place of /frame/input
constexpr const char* kPictureFrameTopic = "/frame/picture";  // in place of /frame/input
constexpr const char* kFrameOutputTopic = "/frame/output";
constexpr const char* kMotionInputTopic = "/motion/input";
constexpr const char* kMotionOutputTopic = "/motion/output";

}  // namespace kelpie
