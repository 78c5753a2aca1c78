// SPDX-License-Identifier: Apache-2.0
// Exported files, read back by the definitions that they hold themselves.
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "robot/agent/log/LoggedTypes.h"
#include "robot/core/log/LogReader.h"
#include "robot/core/log/LogTopics.h"
#include "tools/picture/Jpeg.h"
#include "tools/sim/world/Truth.h"
#include "tools/viewer/Export.h"
#include "tools/viewer/ViewerFile.h"

namespace kelpie::viewer {
namespace {

namespace fs = std::filesystem;
namespace pb = google::protobuf;

constexpr TimeUs kStart{1150279200000000};  // 14 June 2006, 10:00 UTC
constexpr int kFrames = 6;

// Decodes as a reader that knows nothing of ours.
class OwnSchema {
 public:
  explicit OwnSchema(const LogSchema& schema) {
    pb::FileDescriptorSet files;
    EXPECT_TRUE(files.ParseFromString(schema.text));
    for (const auto& file : files.file()) EXPECT_NE(pool_.BuildFile(file), nullptr) << file.name();
    type_ = pool_.FindMessageTypeByName(schema.name);
  }
  // The message as text; empty where it does not decode.
  std::string textOf(const LogMessage& message) {
    if (type_ == nullptr) return {};
    const std::unique_ptr<pb::Message> value(factory_.GetPrototype(type_)->New());
    if (!value->ParseFromArray(message.data, static_cast<int>(message.size))) return {};
    return value->ShortDebugString();
  }

 private:
  pb::DescriptorPool pool_;
  pb::DynamicMessageFactory factory_;
  const pb::Descriptor* type_ = nullptr;
};

struct Topic {
  std::string type;
  std::vector<std::string> messages;  // as text
  std::vector<TimeUs> times;
};
using Topics = std::map<std::string, Topic>;

class Export : public testing::Test {
 protected:
  Export() {
    std::string pattern = (fs::temp_directory_path() / "kelpieXXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~Export() override { fs::remove_all(folder_); }
  std::string pathOf(const std::string& name) const { return (folder_ / name).string(); }

  // A blue goalie that believes to be where its team's goal is; a red forward plays with it.
  static void writeFrame(LogWriter& log, TimeUs time, std::uint32_t frame) {
    const auto input = std::make_unique<PictureFrame>();
    input->frame = frame;
    input->time = time;
    input->sensors.joints[Joint::neckTilt] = Angle::deg(-10.0);
    const auto jpeg = picture::jpegOf(input->image, 60);
    input->jpeg.resize(jpeg.size());
    std::copy(jpeg.begin(), jpeg.end(), input->jpeg.begin());
    log.write(kPictureFrameTopic, time, *input);
    const auto output = std::make_unique<FrameOutput>();
    output->time = time;
    output->body.camera.axes = {1, 0, 0, 0, 0, 1, 0, -1, 0};
    output->world.pose = {{180.0, 20.0}, Angle::deg(90.0)};
    output->world.ball.present = true;
    output->world.ball.position = {60.0, 40.0};
    log.write(kFrameOutputTopic, time, *output);
  }
  static void writeWorld(LogWriter& log, TimeUs time) {
    sim::TruthFrame truth;
    truth.time = time;
    sim::RobotTruth blue;
    blue.team = TeamColour::blue;
    blue.pose = {{180.0, 500.0}, Angle::deg(-90.0)};
    truth.robots.push_back(blue);
    truth.robots.push_back({TeamColour::red, 2, {{100.0, 200.0}, Angle::deg(90.0)}, {}});
    truth.ball = {120.0, 220.0};
    log.write(sim::kTruthTopic, time, truth);
  }
  std::string logOf(TeamColour team, std::uint8_t player, const std::string& name) const {
    LogWriter log = std::move(*LogWriter::open(pathOf(name)));
    const auto config = std::make_unique<agent::AgentConfig>();
    config->team = team;
    config->player = player;
    log.write(kConfigTopic, TimeUs{}, *config);
    sim::MatchEvent event;
    event.kind = sim::EventKind::goal;
    event.player = 2;
    log.write(sim::kEventTopic, TimeUs{}, event);
    for (std::uint32_t i = 0; i < kFrames; ++i) {
      writeFrame(log, TimeUs{33000 * i + 1000}, i);
      writeWorld(log, TimeUs{33000 * i + 2000});
    }
    EXPECT_TRUE(log.close());
    return pathOf(name);
  }
  Expected<Exported> exported(const std::vector<std::string>& logs) const {
    auto file = std::move(*ViewerFile::create(pathOf("viewer.mcap")));
    auto result = exportLogs(logs, kStart, file);
    EXPECT_TRUE(file.close());
    return result;
  }
  std::string bytes() const {
    std::ifstream file(pathOf("viewer.mcap"), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  Topics topics() const {
    Topics topics;
    std::map<const LogSchema*, std::unique_ptr<OwnSchema>> schemas;
    auto reader = LogReader::open(pathOf("viewer.mcap"));
    LogMessage message;
    while (reader->next(message)) {
      auto& schema = schemas[&message.schema()];
      if (schema == nullptr) schema = std::make_unique<OwnSchema>(message.schema());
      Topic& topic = topics[message.topic()];
      topic.type = message.schema().name;
      topic.messages.push_back(schema->textOf(message));
      topic.times.push_back(message.time);
    }
    EXPECT_TRUE(reader->lacks().empty());
    return topics;
  }

  fs::path folder_;
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(Export, EveryMessageDecodesByTheDefinitionThatTheFileHolds) {
  const auto result = exported({logOf(TeamColour::blue, 1, "blue-1.mcap")});
  ASSERT_TRUE(result) << result.error();
  EXPECT_EQ(result->frames, kFrames);
  EXPECT_TRUE(result->lacks.empty());
  const Topics all = topics();
  EXPECT_GE(all.size(), 18U);
  for (const auto& [name, topic] : all)
    for (const std::string& text : topic.messages) EXPECT_FALSE(text.empty()) << name;
  EXPECT_EQ(all.at("/field").type, "foxglove.SceneUpdate");
  EXPECT_EQ(all.at("/blue1/camera").type, "foxglove.CompressedImage");
}

TEST_F(Export, WhatARobotBelievesAndWhatIsTrueAreInOneMap) {
  ASSERT_TRUE(exported({logOf(TeamColour::blue, 1, "blue-1.mcap")}));
  Topics all = topics();
  const std::string pose = all["/blue1/pose"].messages.front();
  EXPECT_TRUE(holds(pose, "position { x: 1.8 y: 5.2 }")) << pose;
  EXPECT_TRUE(holds(all["/blue1/ball/pose"].messages.front(), "position { x: 3 y: 5 z: 0.042 }"));
  EXPECT_TRUE(holds(all["/ball/true/pose"].messages.front(), "position { x: 1.2 y: 2.2 z: 0.042 }"))
      << all["/ball/true/pose"].messages.front();
  const std::string tf = all["/tf"].messages[1];
  EXPECT_TRUE(holds(tf, "child_frame_id: \"blue1/true\" translation { x: 1.8 y: 5 }")) << tf;
}

TEST_F(Export, APictureIsPassedOnAsItIs) {
  ASSERT_TRUE(exported({logOf(TeamColour::blue, 1, "blue-1.mcap")}));
  Topics all = topics();
  ASSERT_EQ(all["/blue1/camera"].messages.size(), kFrames);
  EXPECT_TRUE(holds(all["/blue1/camera"].messages[0], "format: \"jpeg\""));
  EXPECT_TRUE(holds(all["/blue1/camera"].messages[0], "frame_id: \"blue1/camera\""));
  EXPECT_TRUE(holds(all["/blue1/camera"].messages[0], "JFIF"));
  EXPECT_TRUE(holds(all["/blue1/camera/calibration"].messages[0], "width: 208 height: 160"));
}

TEST_F(Export, TimeZeroIsTheStart) {
  ASSERT_TRUE(exported({logOf(TeamColour::blue, 1, "blue-1.mcap")}));
  Topics all = topics();
  EXPECT_EQ(all["/field"].times.front().us, kStart.us);
  EXPECT_EQ(all["/blue1/pose"].times.back().us, kStart.us + 33000 * (kFrames - 1) + 1000);
  EXPECT_TRUE(holds(all["/blue1/pose"].messages[0], "seconds: 1150279200 nanos: 1000000"));
}

TEST_F(Export, WhatTwoLogsTellOfTheWorldIsToldOnce) {
  ASSERT_TRUE(exported(
      {logOf(TeamColour::blue, 1, "blue-1.mcap"), logOf(TeamColour::red, 2, "red-2.mcap")}));
  Topics all = topics();
  EXPECT_EQ(all["/ball/true"].messages.size(), kFrames);
  ASSERT_EQ(all["/referee"].messages.size(), 1U);
  EXPECT_TRUE(holds(all["/referee"].messages[0], "Goal of red by player 2."));
  EXPECT_EQ(all["/field"].messages.size(), 1U);
  EXPECT_EQ(all["/red2/pose"].messages.size(), kFrames);
}

TEST_F(Export, ARobotWithoutALogHasABodyAllTheSame) {
  ASSERT_TRUE(exported({logOf(TeamColour::blue, 1, "blue-1.mcap")}));
  Topics one = topics();
  EXPECT_TRUE(holds(one["/robots"].messages[0], "\"red2 body\""));
  EXPECT_FALSE(holds(one["/robots"].messages[0], "\"blue1 body\""));
  EXPECT_TRUE(
      holds(one["/blue1/robot"].messages[1], "frame_id: \"blue1/true\" id: \"blue1 body\""));
}

TEST_F(Export, TheSameLogsGiveTheSameBytes) {
  const std::string log = logOf(TeamColour::blue, 1, "blue-1.mcap");
  ASSERT_TRUE(exported({log}));
  const std::string once = bytes();
  ASSERT_TRUE(exported({log}));
  EXPECT_TRUE(once == bytes());
}

TEST_F(Export, OfACutLogWhatIsWholeIsExportedAndTheRestNamed) {
  const std::string cut = pathOf("cut.mcap");
  LogWriter out = std::move(*LogWriter::open(cut, LogOptions{}));  // record by record
  out.write(kConfigTopic, TimeUs{}, *std::make_unique<agent::AgentConfig>());
  writeFrame(out, TimeUs{1000}, 0);
  const auto place = out.bytes();
  writeFrame(out, TimeUs{34000}, 1);
  ASSERT_TRUE(out.close());
  fs::resize_file(cut, place + 100);
  const auto result = exported({cut});
  ASSERT_TRUE(result) << result.error();
  EXPECT_EQ(result->frames, 1U);
  ASSERT_EQ(result->lacks.size(), 1U);
  EXPECT_TRUE(holds(result->lacks[0], cut + ": cut off at byte")) << result->lacks[0];
}

TEST_F(Export, AFrameOutOfItsRangeIsLeftOutAndCounted) {
  LogWriter log = std::move(*LogWriter::open(pathOf("log")));
  log.write(kConfigTopic, TimeUs{}, *std::make_unique<agent::AgentConfig>());
  writeFrame(log, TimeUs{1000}, 0);
  const auto input = std::make_unique<FrameInput>();
  input->game.state = static_cast<PlayState>(200);
  log.write(kFrameInputTopic, TimeUs{34000}, *input);
  log.write(kFrameOutputTopic, TimeUs{34000}, *std::make_unique<FrameOutput>());
  ASSERT_TRUE(log.close());
  const auto result = exported({pathOf("log")});
  ASSERT_TRUE(result) << result.error();
  EXPECT_EQ(result->frames, 1U);
  ASSERT_EQ(result->lacks.size(), 1U);
  EXPECT_TRUE(holds(result->lacks[0], "log: 1 damaged messages left out")) << result->lacks[0];
}

TEST_F(Export, ASecondLogOfARobotIsRefused) {
  const std::string log = logOf(TeamColour::blue, 1, "blue-1.mcap");
  const std::string again = logOf(TeamColour::blue, 1, "again.mcap");
  EXPECT_EQ(exported({log, again}).error(), again + ": is of blue1, as another of the logs is");
}

TEST_F(Export, AFolderAndAFileWithoutFramesAreNamed) {
  EXPECT_TRUE(holds(exported({folder_.string()}).error(), ": is a folder; name its logs"));
  LogWriter log = std::move(*LogWriter::open(pathOf("empty")));
  ASSERT_TRUE(log.close());
  EXPECT_EQ(exported({pathOf("empty")}).error(),
            pathOf("empty") + ": holds no frames with outputs to show");
}

}  // namespace
}  // namespace kelpie::viewer
