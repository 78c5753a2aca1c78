// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include "tests/stick/Sticks.h"
#include "tools/stick/EmonLog.h"

namespace kelpie::stick {
namespace {

constexpr std::uint32_t kMoved = 0x22200000;

// A program of two calls for the robot's class of CPU: what died, who called, who called that.
constexpr const char* kProgram =
    "extern \"C\" {\n"
    "__attribute__((noinline)) int innermost(volatile int* p) {\n"
    "  return *p + 1;\n"
    "}\n"
    "__attribute__((noinline)) int middle(volatile int* p) {\n"
    "  return innermost(p) * 3;\n"
    "}\n"
    "int __start() {\n"
    "  int x = 5;\n"
    "  return middle(&x) + middle(&x);\n"
    "}\n"
    "}\n";

// What stands ahead of the instructions in their segment looks like a jal.
const std::string kCallsInANote = "0x0000000c0000000c0000000c0000000c0000000c";

struct Program {
  std::string elf;
  std::unique_ptr<ElfObject> object;
  std::uint32_t innermost = 0, afterMiddlesCall = 0, afterStartsCall = 0;
};

std::uint32_t addressOf(const std::string& elf, const std::string& symbol) {
  const auto symbols = runProgram({findProgram({"mipsel-linux-gnu-nm"}), elf});
  const auto at = symbols->find(" T " + symbol + "\n");
  return static_cast<std::uint32_t>(std::stoul(symbols->substr(at - 8, 8), nullptr, 16));
}

// Behind the first call from this address on.
std::uint32_t afterCall(const ElfObject& object, std::uint32_t from) {
  for (std::uint32_t at = from; at < from + 400; at += 4)
    if (object.followsCall(at)) return at;
  return 0;
}

bool makeProgram(Program& program) {
  const std::string compiler = findProgram({"mipsel-linux-gnu-g++"});
  if (compiler.empty()) return false;
  const std::string source = testing::TempDir() + "/program.cpp";
  program.elf = testing::TempDir() + "/program.elf";
  put(source, kProgram);
  const auto compiled = runProgram({compiler, "-g", "-O1", "-march=mips2", "-mabicalls", "-fPIC",
                                    "-mno-shared", "-fno-optimize-sibling-calls", "-nostdlib",
                                    "-static", "-Wl,--build-id=" + kCallsInANote,
                                    "-Wl,-Map," + program.elf + ".map", "-o", program.elf, source});
  EXPECT_TRUE(compiled) << compiled.error();
  auto object = ElfObject::parse(*readWhole(program.elf), program.elf);
  EXPECT_TRUE(object) << object.error();
  program.object = std::make_unique<ElfObject>(std::move(*object));
  program.innermost = addressOf(program.elf, "innermost");
  program.afterMiddlesCall = afterCall(*program.object, addressOf(program.elf, "middle"));
  program.afterStartsCall = afterCall(*program.object, addressOf(program.elf, "__start"));
  return true;
}

std::string logOf(const Program& program) {
  return fmt::format(
      "mCOOP exception\n[exception info]\ntime stamp: 0x000000004daf5139\n"
      "status:$12: 0x0000ff13, cause:$13: 0x00000010\n"
      "badvaddr: $8: 0x73692067, epc:$14: 0x{:08x}\n"
      "[initial value info]\n gp:r28: 0x{:08x}\n ra:r31: 0x{:08x}\n\n"
      "[stack info]\n area: 0x220a0c08 - 0x220a1808, sp: 0x220a13f0\n[stack dump]\n"
      "220a13f0: 22642658 {:08x} 00000000 {:08x}  X&d\".N....H#.K..\n*\n",
      program.innermost + kMoved, program.object->globalPointer() + kMoved,
      program.afterMiddlesCall + kMoved, program.afterStartsCall + kMoved,
      program.innermost + kMoved);
}

TEST(EmonLog, NamesFunctionsAndLinesOfACrash) {
  Program program;
  if (!makeProgram(program)) GTEST_SKIP() << "g++-mipsel-linux-gnu is not installed";
  const auto log = parseEmonLog(logOf(program), "EMON.LOG");
  ASSERT_TRUE(log) << log.error();
  EXPECT_EQ(causeText(*log->cause), "4: address error at a load or a fetch");
  EXPECT_EQ(*log->badAddress, 0x73692067U);
  const auto offset = loadOffset(*log, *program.object, std::nullopt);
  ASSERT_TRUE(offset) << offset.error();
  EXPECT_EQ(*offset, kMoved);
  const auto places = crashPlaces(*log, *program.object, *offset);
  ASSERT_TRUE(places) << places.error();
  ASSERT_EQ(places->size(), 3U);  // the start of a function on the stack follows no call
  const auto lines = linesOf(*places, program.elf);
  ASSERT_TRUE(lines) << lines.error();
  EXPECT_NE((*lines)[0].find("innermost"), std::string::npos) << (*lines)[0];
  EXPECT_NE((*lines)[1].find("middle"), std::string::npos) << (*lines)[1];
  EXPECT_NE((*lines)[1].find("program.cpp:6"), std::string::npos) << (*lines)[1];
  EXPECT_NE((*lines)[2].find("__start"), std::string::npos) << (*lines)[2];
  EXPECT_EQ((*places)[1].address, program.afterMiddlesCall - 8);  // the call itself
  EXPECT_EQ((*places)[2].where, "0x220a13f4");
}

TEST(EmonLog, LinesOfAnyLengthAreReadAndThoseOfNonsenseTakeNoStack) {
  const auto log = parseEmonLog("epc:$14: 0x00400710\n" + std::string(3000000, ' ') + "x\n" +
                                    "gp:r28" + std::string(300000, ' ') + "\n",
                                "EMON.LOG");
  ASSERT_TRUE(log) << log.error();
  EXPECT_EQ(*log->counter, 0x00400710U);
}

TEST(EmonLog, TellsWhereTheObjectWasByHandWhenTheLogDoesNot) {
  Program program;
  if (!makeProgram(program)) GTEST_SKIP() << "g++-mipsel-linux-gnu is not installed";
  EmonLog log;
  log.counter = program.innermost + kMoved;
  EXPECT_NE(loadOffset(log, *program.object, std::nullopt).error().find("--loaded-at"),
            std::string::npos);
  EXPECT_EQ(*loadOffset(log, *program.object, kMoved), kMoved);
  const auto places = crashPlaces(log, *program.object, kMoved);
  ASSERT_TRUE(places) << places.error();
  EXPECT_EQ(places->front().address, program.innermost);
  EXPECT_NE(
      crashPlaces(log, *program.object, kMoved + 0x1000000).error().find("not in this object"),
      std::string::npos);
}

// What the linker's map says of a function: "                0x004001c0                middle".
std::uint32_t addressInMap(const std::string& map, const std::string& function) {
  const auto at = map.find(" " + function + "\n");
  return static_cast<std::uint32_t>(std::stoul(map.substr(map.rfind("0x", at)), nullptr, 16));
}

TEST(EmonLog, NamesTheFunctionThatTheMapOfTheLinkHasAtTheAddress) {
  Program program;
  if (!makeProgram(program)) GTEST_SKIP() << "g++-mipsel-linux-gnu is not installed";
  const std::string map = *readWhole(program.elf + ".map");
  for (const std::string function : {"innermost", "middle"}) {
    EmonLog log;
    log.counter = addressInMap(map, function) + 4 + kMoved;
    log.globalPointer = program.object->globalPointer() + kMoved;
    const auto offset = loadOffset(log, *program.object, std::nullopt);
    const auto lines = linesOf(*crashPlaces(log, *program.object, *offset), program.elf);
    ASSERT_TRUE(lines) << lines.error();
    EXPECT_EQ(lines->front().rfind(function + " (", 0), 0U) << lines->front();
  }
}

// As the SDK's mkbin moves it for the stick, where only _gp keeps its address.
TEST(EmonLog, RefusesTheProgramThatWasMovedToAddress0) {
  Program program;
  if (!makeProgram(program)) GTEST_SKIP() << "g++-mipsel-linux-gnu is not installed";
  std::string bytes = *readWhole(program.elf);
  const std::uint32_t table = 52;  // the program headers follow the header
  for (std::uint32_t at = table; at < table + 32 * std::uint32_t(bytes[44]); at += 32)
    bytes.replace(at + 8, 4, 4, '\0');  // the address where it shall be loaded
  const auto moved = ElfObject::parse(bytes, "agent.bin");
  ASSERT_FALSE(moved);
  EXPECT_NE(moved.error().find("take the agent.nosnap.elf"), std::string::npos) << moved.error();
}

TEST(EmonLog, SaysWhenAddr2lineIsMissing) {
  const std::string path = getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  const auto lines = linesOf({{"died in", 4}}, "agent.elf");
  setenv("PATH", path.c_str(), 1);
  EXPECT_NE(lines.error().find("addr2line is missing"), std::string::npos);
}

TEST(EmonLog, RefusesWhatIsNoLogAndWhatIsNoElfFile) {
  EXPECT_FALSE(parseEmonLog("hello\n", "EMON.LOG"));
  EXPECT_FALSE(parseEmonLog("badvaddr: $8: 0x1, epc:$14: none\n", "EMON.LOG"));
  EXPECT_FALSE(ElfObject::parse("", "a"));
  EXPECT_FALSE(ElfObject::parse(std::string(100, 'x'), "a"));
}

// Offsets that lead anywhere, as in a file that was cut or damaged.
TEST(ElfObject, ReadsNothingOutsideOfADamagedFile) {
  Program program;
  if (!makeProgram(program)) GTEST_SKIP() << "g++-mipsel-linux-gnu is not installed";
  const std::string whole = *readWhole(program.elf);
  for (std::size_t byte = 16; byte < 52; ++byte) {
    std::string damaged = whole;
    damaged[byte] = '\xff';
    const auto object = ElfObject::parse(damaged, "a");
    EXPECT_FALSE(object && object->followsCall(0xFFFFFFFCU));
  }
  for (std::size_t size = 0; size < whole.size(); size += whole.size() / 40 + 1)
    static_cast<void>(ElfObject::parse(whole.substr(0, size), "a"));
}

}  // namespace
}  // namespace kelpie::stick
