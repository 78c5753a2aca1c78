// SPDX-License-Identifier: Apache-2.0
// Schema, encoding and decoding of the messages of an agent's log, compiled once in
// LoggedTypes.cpp: they need the tables of every struct within, which the compiler would make
// again wherever a log is read or written. Whoever does that includes this.
#pragma once

#include "robot/agent/AgentConfig.h"
#include "robot/core/fields/Encoding.h"
#include "robot/core/types/FrameInput.h"
#include "robot/core/types/FrameOutput.h"
#include "robot/core/types/Motion.h"
#include "robot/core/types/PictureFrame.h"
#include "robot/core/types/PlaneFrame.h"

namespace kelpie {

extern template std::string schemaText<agent::AgentConfig>();
extern template std::size_t encodedSize(const agent::AgentConfig&);
extern template void encode(const agent::AgentConfig&, std::vector<std::uint8_t>&);
extern template bool decode(const std::uint8_t*, std::size_t, agent::AgentConfig&);

extern template std::string schemaText<FrameInput>();
extern template std::size_t encodedSize(const FrameInput&);
extern template void encode(const FrameInput&, std::vector<std::uint8_t>&);
extern template bool decode(const std::uint8_t*, std::size_t, FrameInput&);

extern template std::string schemaText<PlaneFrame>();
extern template std::size_t encodedSize(const PlaneFrame&);
extern template void encode(const PlaneFrame&, std::vector<std::uint8_t>&);
extern template bool decode(const std::uint8_t*, std::size_t, PlaneFrame&);

extern template std::string schemaText<PictureFrame>();
extern template std::size_t encodedSize(const PictureFrame&);
extern template void encode(const PictureFrame&, std::vector<std::uint8_t>&);
extern template bool decode(const std::uint8_t*, std::size_t, PictureFrame&);

extern template std::string schemaText<FrameOutput>();
extern template std::size_t encodedSize(const FrameOutput&);
extern template void encode(const FrameOutput&, std::vector<std::uint8_t>&);
extern template bool decode(const std::uint8_t*, std::size_t, FrameOutput&);

extern template std::string schemaText<MotionInput>();
extern template std::size_t encodedSize(const MotionInput&);
extern template void encode(const MotionInput&, std::vector<std::uint8_t>&);
extern template bool decode(const std::uint8_t*, std::size_t, MotionInput&);

extern template std::string schemaText<MotionOutput>();
extern template std::size_t encodedSize(const MotionOutput&);
extern template void encode(const MotionOutput&, std::vector<std::uint8_t>&);
extern template bool decode(const std::uint8_t*, std::size_t, MotionOutput&);

}  // namespace kelpie
