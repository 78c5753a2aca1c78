// SPDX-License-Identifier: Apache-2.0
// fuzz_seeds FOLDER   writes the first inputs of each target into FOLDER/<target>, by our own
// writers: from them libFuzzer makes what tests/fuzz/corpus keeps. To be run again when a format
// has changed.
#include <filesystem>
#include <memory>

#include "robot/core/log/LogWriter.h"
#include "robot/core/types/Command.h"
#include "robot/core/types/PlaneFrame.h"
#include "robot/net/GameControlData.h"
#include "robot/net/TeamPacket.h"
#include "tests/core/RandomValue.h"
#include "tests/fuzz/Input.h"
#include "tools/calibrate/Images.h"
#include "tools/cli/log/Recording.h"
#include "tools/picture/Jpeg.h"
#include "tools/sim/bodies/Randomisation.h"
#include "vision/colour/TableFile.h"

namespace {

using namespace kelpie;
using fuzz::Bytes;

class Folder {
 public:
  Folder(const std::string& root, const std::string& target) : path_(root + "/" + target + "/") {
    std::filesystem::create_directories(path_);
  }
  std::string file(const std::string& name) const { return path_ + name; }
  void put(const std::string& name, const Bytes& bytes) const {
    std::FILE* const out = std::fopen(file(name).c_str(), "wb");
    if (out == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), out) != bytes.size())
      std::abort();
    std::fclose(out);
  }
  void put(const std::string& name, const std::string& text) const {
    put(name, Bytes(text.begin(), text.end()));
  }

 private:
  std::string path_;
};

Bytes bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

Bytes behind(const Bytes& before, const Bytes& bytes) {
  Bytes all = before;
  all.insert(all.end(), bytes.begin(), bytes.end());
  return all;
}

// A length in two bytes, that many, and then the rest.
Bytes inTwo(const Bytes& first, const Bytes& second) {
  const Bytes length = {static_cast<std::uint8_t>(first.size() >> 8U),
                        static_cast<std::uint8_t>(first.size() & 0xFFU)};
  return behind(length, behind(first, second));
}

// Chunks without a checksum (0 says so), that bytes in them may change unseen.
Bytes unchecked(Bytes log) {
  std::uint64_t length = 0;
  for (std::size_t at = mcap::kMagic.size(); at + mcap::kRecordHead + 28 < log.size();
       at += mcap::kRecordHead + length) {
    std::memcpy(&length, &log[at + 1], sizeof length);
    if (static_cast<mcap::Op>(log[at]) == mcap::Op::chunk) std::fill_n(&log[at + 33], 4, 0);
  }
  return log;
}

void writeLog(const Folder& to, const std::string& name, const LogOptions& options, bool checked) {
  auto log = LogWriter::open(to.file(name), options);
  if (!log) std::abort();
  Random random(1);
  log->metadata("about", {{"a", "b"}});
  log->attachment("a", "text/plain", {'b'});
  for (int i = 0; i < 6; ++i) {
    sim::MatchEvent event;
    randomise(event, random);
    log->write(sim::kEventTopic, TimeUs{400000 * i}, event);
    WalkRequest walk;
    randomise(walk, random);
    log->write("/walk", TimeUs{400000 * i}, walk);
  }
  if (!log->close()) std::abort();
  if (!checked) to.put(name, unchecked(*vision::readBytes(to.file(name))));
}

void writeLogs(const Folder& to) {
  writeLog(to, "alone", {}, true);
  writeLog(to, "plain", {true, "", 150, 1000000}, false);
  writeLog(to, "plain-checked", {true, "", 150, 1000000}, true);
  writeLog(to, "zstd", {true, "zstd", 150, 1000000}, false);
}

void writeSchemas(const Folder& to) {
  Random random(2);
  Command command;
  randomise(command, random);
  Bytes message;
  encode(command, message);
  std::string text = schemaText<Command>();
  to.put("today", inTwo(bytesOf(text), message));
  const std::size_t at = text.find("float64");
  if (at != std::string::npos) text.replace(at, 7, "float32");
  to.put("narrow", inTwo(bytesOf(text), message));
}

void writeRadio(const Folder& to) {
  Random random(3);
  for (const char* name : {"some", "other"}) {
    const auto packet = std::make_unique<net::TeamPacket>();
    randomise(packet->message, random);
    RadioPacket bytes;
    if (!net::encode(*packet, bytes)) std::abort();
    to.put(name, Bytes(bytes.bytes.begin(), bytes.bytes.end()));
  }
}

void writeControl(const Folder& to) {
  net::GameControlData control;
  control.teams[1].colour = TeamColour::red;
  to.put("version4", net::encodeControl(control));
  for (const auto& layout : net::kControlLayouts) {
    Bytes bytes(layout.size, 1);
    const std::string mark = "RGme";
    std::copy(mark.begin(), mark.end(), bytes.begin());
    bytes[4] = static_cast<std::uint8_t>(layout.version);
    to.put("ones" + std::to_string(layout.version), bytes);
  }
}

void writeParameters(const Folder& to) {
  to.put("team",
         "[behaviour.task]\nplayer = 1\ngrab = false\n[gps.ball]\n[vision.ball]\nminSamples = 6\n"
         "maxDistance = \"450cm\"\ndirectionError = \"2.5deg\"\n");
  to.put("walk",
         "[actuator.walks.normal]\n[actuator]\n[game]\n[body]\n[field]\nlength = \"540cm\"\n");
  to.put("odd",
         "a.b.c = [1, 2.5, inf, nan, 0x1F, 1979-05-27]\n[[list]]\nx = { y = 'z' }\n"
         "\"\\u00e9\" = \"\"\"\na\"\"\"\n");
}

void writeMotions(const Folder& to) {
  to.put(
      "all",
      "about = \"\"\"a\"\"\"\nslew = 20.0\nat_once = true\nreturn_ticks = 30\n"
      "way = { forward = 1.5, left = -1, turn = 3, forward_sd = 1, left_sd = 1, turn_sd = 2 }\n"
      "kick = { ahead = 20, left = 1, distance = 90, distance_sd = 9, direction = 5, "
      "direction_sd = 3 }\n"
      "[[frame]]\nticks = 12\ninterpolate = true\ngain = 0.5\nhead = [-10, 20, 3.5]\nmouth = -20\n"
      "front = [1, 2, 3]\nhind = [4, 5, 6]\n"
      "[[frame]]\nticks = 3\nlegs = \"walk\"\nwalk = \"dribble\"\nforward = 10\nleft = 1\nturn = "
      "9\n");
  to.put("legs",
         "[[frame]]\nticks = 1\nleft_front = [1, 2, 3]\nleft_hind = [1, 2, 3]\n"
         "right_front = [1, 2, 3]\nright_hind = [1, 2, 4]\n[[frame]]\nticks = 2\nlegs = \"stay\"\n"
         "[[frame]]\nticks = 2\nlegs = \"stance\"\n");
  to.put("mirror", "about = \"\"\nmirror = \"none\"\n");
}

void writeTables(const Folder& to) {
  const Bytes patch = {0, 0, 40, 2, 1, 2, 3};
  to.put("own", behind({0}, bytesOf("KELPIETB")));
  to.put("colour", behind({1, 0}, patch));
  to.put("ring", behind({2, 0}, patch));
  to.put("broken", behind({2, 1}, patch));
}

void writeImages(const Folder& to) {
  const auto image = std::make_unique<Image>();
  std::fill_n(image->y.begin(), kImagePixels / 2, std::uint8_t{200});
  const std::string png = fuzz::placeOf(".png");
  if (!calibrate::writePicture(*image, png)) std::abort();
  to.put("png", behind({0}, *vision::readBytes(png)));
  std::filesystem::remove(png);
  to.put("small", Bytes{1, 1, 2, 3});
  to.put("yuv", Bytes{2, 1, 2, 3});
  to.put("rows", Bytes{3, 1, 2, 3});
  to.put("jpeg", behind({4}, picture::jpegOf(*image, 20)));
  const auto plane = std::make_unique<ClassNumbers>();
  const auto code = std::make_unique<PlaneCode>();
  std::fill_n(plane->begin(), 1000, std::uint8_t{3});
  encodePlane(*plane, *code);
  to.put("plane", behind({5}, Bytes(code->begin(), code->end())));
}

void writeSticks(const Folder& to) {
  to.put("start", behind({0}, bytesOf("KELPIEMS")));
  to.put("sound", Bytes{1});
  to.put("head", Bytes{1, 0, 0, 24, 3, 5, 0, 0, 0});
  to.put("parameters", Bytes{1, 0, 1, 0, 1, 1, 2, 0, 4, 0, 7, 0, 0, 0, 0, 0, 0, 0xf0, 0x3f});
  to.put("unsealed", Bytes{2, 0, 0, 60, 0, 9});
}

void writeSettings(const Folder& to) {
  to.put("fixed",
         "# of the team\nESSID = fourlegged\nWEPENABLE=1\r\nWEPKEY=0x0123456789\n\nAPMODE=1\n"
         "ETHER_IP=10.0.1.3\nETHER_NETMASK=255.255.255.0\nIP_GATEWAY=10.0.1.1\nCHANNEL=3\n");
  to.put("dhcp",
         "\xEF\xBB\xBF"
         "ESSID=a\nUSE_DHCP=1\nSSDP_ENABLE=1\nDNS_SERVER_1=10.0.0.1\nHOSTNAME=dog\n"
         "WEPENABLE=1\nWEPKEY=abcde\n");
}

// A linked program of 64 bytes of code, one call among them, and the symbol _gp.
Bytes program() {
  Bytes elf(52 + 32 + 64 + 2 * 40 + 2 * 16 + 8);
  const auto put = [&](std::size_t at, std::initializer_list<std::uint32_t> words) {
    for (const std::uint32_t word : words) {
      std::memcpy(&elf[at], &word, sizeof word);
      at += 4;
    }
  };
  put(0, {0x464C457F, 0x00010101});
  put(16, {0x00080002, 1, 0, 52, 148});  // kind and machine; programs at 52, sections at 148
  put(40, {0x00200034, 0x00280001, 2});  // one program, two sections
  put(52, {1, 84, 0x400000, 0, 64, 64, 5});
  put(92, {0x0320f809});  // jalr t9
  put(148, {0, 2, 0, 0, 228, 32, 1});
  put(188, {0, 3, 0, 0, 260, 8});
  put(244, {1, 0x408000});
  std::memcpy(&elf[261], "_gp", 4);
  return elf;
}

void writeCrashes(const Folder& to) {
  const std::string log =
      "status:$12: 0x0000ff13, cause:$13: 0x00000010\n"
      "badvaddr: $8: 0x73692067, epc:$14: 0x00600004\n gp:r28: 0x00608000\n ra:r31: 0x00600010\n"
      "[stack dump]\n220a13f0: 22642658 00600010 00000000 00600004  X&d\n*\n";
  to.put("sound", inTwo(bytesOf(log), program()));
}

void writeSheets(const Folder& to) {
  const std::string help = cli::recordingHelp();
  to.put("sensors", behind({0}, bytesOf(help.substr(help.find("t_s,")))));
  to.put("pixels", behind({1}, bytesOf("Y,Cr,Cb,class\n1,2,3,orange\n4,5,6,7\n0,255,128,none\n")));
  to.put("boxes", behind({2}, bytesOf("# boxes\nnone.png 40 20 90 60 blue\n")));
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) return 2;
  const std::string root = words[1];
  writeLogs({root, "log"});
  writeSchemas({root, "schema"});
  writeRadio({root, "radio"});
  writeControl({root, "control"});
  writeParameters({root, "parameters"});
  writeMotions({root, "motion"});
  writeTables({root, "table"});
  writeImages({root, "image"});
  writeSticks({root, "stick"});
  writeSettings({root, "settings"});
  writeCrashes({root, "crash"});
  writeSheets({root, "sheet"});
  return 0;
}
