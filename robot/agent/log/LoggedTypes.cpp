// SPDX-License-Identifier: Apache-2.0
#include "robot/agent/log/LoggedTypes.h"

namespace kelpie {

template std::string schemaText<agent::AgentConfig>();
template std::size_t encodedSize(const agent::AgentConfig&);
template void encode(const agent::AgentConfig&, std::vector<std::uint8_t>&);
template bool decode(const std::uint8_t*, std::size_t, agent::AgentConfig&);

template std::string schemaText<FrameInput>();
template std::size_t encodedSize(const FrameInput&);
template void encode(const FrameInput&, std::vector<std::uint8_t>&);
template bool decode(const std::uint8_t*, std::size_t, FrameInput&);

template std::string schemaText<PlaneFrame>();
template std::size_t encodedSize(const PlaneFrame&);
template void encode(const PlaneFrame&, std::vector<std::uint8_t>&);
template bool decode(const std::uint8_t*, std::size_t, PlaneFrame&);

template std::string schemaText<PictureFrame>();
template std::size_t encodedSize(const PictureFrame&);
template void encode(const PictureFrame&, std::vector<std::uint8_t>&);
template bool decode(const std::uint8_t*, std::size_t, PictureFrame&);

template std::string schemaText<FrameOutput>();
template std::size_t encodedSize(const FrameOutput&);
template void encode(const FrameOutput&, std::vector<std::uint8_t>&);
template bool decode(const std::uint8_t*, std::size_t, FrameOutput&);

template std::string schemaText<MotionInput>();
template std::size_t encodedSize(const MotionInput&);
template void encode(const MotionInput&, std::vector<std::uint8_t>&);
template bool decode(const std::uint8_t*, std::size_t, MotionInput&);

template std::string schemaText<MotionOutput>();
template std::size_t encodedSize(const MotionOutput&);
template void encode(const MotionOutput&, std::vector<std::uint8_t>&);
template bool decode(const std::uint8_t*, std::size_t, MotionOutput&);

}  // namespace kelpie
