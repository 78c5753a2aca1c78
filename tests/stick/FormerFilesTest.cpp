// SPDX-License-Identifier: Apache-2.0
// Installing over another program: its files are kept, whatever happens meanwhile.
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <map>

#include "robot/stick/StdioFiles.h"
#include "robot/stick/StickReader.h"
#include "tests/stick/Sticks.h"
#include "tools/stick/StickWriter.h"
#include "tools/stick/medium/FormerFiles.h"
#include "tools/stick/medium/StickDifference.h"

namespace kelpie::stick {
namespace {

using Files = std::map<std::string, std::string>;

// Another program's: it has files under three names of ours, and two under its own.
const Files kFormer = {{kObjectListPath, "/MS/OPEN-R/MW/OBJS/WALKER.BIN\n"},
                       {kConnectPath, "Walker.Legs.OCommandVectorData.S other\n"},
                       {kObjectPath, "another's program of that name"}};
const Files kItsOwn = {{"OPEN-R/MW/OBJS/WALKER.BIN", "walks"}, {"OPEN-R/MW/CONF/W.CFG", "fast"}};

std::string formerStick(const std::string& name) {
  const std::string root = mountedStick(name);
  for (const auto& files : {kFormer, kItsOwn})
    for (const auto& [path, bytes] : files) put(fs::path(root) / path, bytes);
  return root;
}

Files asFiles(const StickTree& tree) {
  Files files;
  for (const auto& file : tree) files[file.path] = file.bytes;
  return files;
}

Files filesIn(const fs::path& root) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), root).string()] = *readWhole(entry.path().string());
  return files;
}

StickVerdict verdictOn(const std::string& root) {
  StdioFiles files(root.c_str());
  return std::make_unique<StickReader>(files)->check();
}

TEST(FormerFiles, AreThoseOfAnotherProgramThatWouldBeReplaced) {
  EXPECT_EQ(asFiles(*formerFiles(sampleTree(), formerStick("former"))), kFormer);
  EXPECT_TRUE(formerFiles(sampleTree(), mountedStick("nothing"))->empty());
}

TEST(FormerFiles, AreRefusedWhereOneCannotBeRead) {
  const std::string root = formerStick("unreadable");
  fs::remove(root + "/" + kConnectPath);
  fs::create_directories(root + "/" + kConnectPath);
  EXPECT_NE(formerFiles(sampleTree(), root).error().find(kConnectPath), std::string::npos);
}

TEST(FormerFiles, AreCalledForeignInADifference) {
  const std::string root = formerStick("foreign");
  std::string all;
  for (const auto& line : differenceLines(sampleTree(), *sampleConfig(), root)) all += line + "\n";
  for (const auto& [path, bytes] : kFormer)
    EXPECT_NE(all.find("foreign  " + path), std::string::npos) << all;
  EXPECT_NE(all.find(std::string("new      ") + kScriptsPath), std::string::npos) << all;
}

// Of another version of the program, as its field lists' number says, damaged, or half removed:
// installing again is what mends such a stick, without more words.
TEST(FormerFiles, AreNoneOnAnEarlierStickOfOurs) {
  const std::string root = mountedStick("earlier");
  ASSERT_TRUE(writeFiles(sampleTree(), root, silently));
  put(fs::path(root) / kScriptsPath, "damaged");
  EXPECT_TRUE(formerFiles(sampleTree(), root)->empty());
  std::string binary = *readWhole(root + "/" + kStickPath);
  binary[16] ^= 1;  // of StickHeader::fieldLists
  put(fs::path(root) / kStickPath, binary);
  EXPECT_EQ(verdictOn(root).fault, StickFault::otherFieldLists);
  EXPECT_TRUE(formerFiles(sampleTree(), root)->empty());
  binary.resize(binary.size() / 2);
  put(fs::path(root) / kStickPath, binary);
  EXPECT_TRUE(formerFiles(sampleTree(), root)->empty());
  fs::remove(root + "/" + kObjectListPath);
  EXPECT_TRUE(formerFiles(sampleTree(), root)->empty());
}

// Who plays says nothing of them: another program may have left them, or their owner.
TEST(FormerFiles, AreSettingsThatOurStickDoesNotListThoughOurAgentStarts) {
  const Files settings = {{kWlanPath, "ESSID=theirs\n"}, {kJamPath, "theirs"}};
  StickContents contents = sampleContents();
  contents.wlan.clear();
  contents.relaxedJams = false;
  const std::string root = mountedStick("settings");
  for (const auto& [path, bytes] : settings) put(fs::path(root) / path, bytes);
  ASSERT_TRUE(writeFiles(*makeTree(*sampleConfig(), contents), root, silently));
  const auto former = formerFiles(sampleTree(), root);
  EXPECT_EQ(asFiles(*former), settings);
  EXPECT_FALSE(haveAnotherProgram(*former));
}

TEST(FormerFiles, AreNoSettingsThatOurStickLists) {
  const std::string root = mountedStick("listed");
  ASSERT_TRUE(writeFiles(sampleTree(), root, silently));
  StickContents contents = sampleContents();
  contents.wlan = "ESSID=other\nETHER_IP=10.0.1.3\n";
  EXPECT_TRUE(formerFiles(*makeTree(*sampleConfig(), contents), root)->empty());
}

TEST(FormerFiles, OfSonysSystemAloneAreNoOtherProgram) {
  const std::string root = mountedStick("system");
  put(fs::path(root) / kWlanPath, "ESSID=theirs\n");
  EXPECT_FALSE(haveAnotherProgram(*formerFiles(sampleTree(), root)));
  EXPECT_TRUE(haveAnotherProgram(*formerFiles(sampleTree(), formerStick("another"))));
}

// An earlier version of ours may have started other objects, as its STICK.BIN tells.
TEST(FormerFiles, AreNoneWhereStickBinListsAnotherObjectList) {
  StickTree earlier = sampleTree();
  earlier.front().bytes += "/MS/OPEN-R/MW/OBJS/MORE.BIN\n";
  ASSERT_EQ(earlier.front().path, kObjectListPath);
  earlier.back().bytes =
      stickBinary(*sampleConfig(), StickTree(earlier.begin(), earlier.end() - 1));
  const std::string root = mountedStick("more");
  ASSERT_TRUE(writeFiles(earlier, root, silently));
  EXPECT_TRUE(formerFiles(sampleTree(), root)->empty());
}

// Somebody has copied another program over our stick: what STICK.BIN lists is still ours.
TEST(FormerFiles, AreDistinguishedFromOursOnAMixedStick) {
  const std::string root = mountedStick("mixed");
  ASSERT_TRUE(writeFiles(sampleTree(), root, silently));
  put(fs::path(root) / kObjectListPath, kFormer.at(kObjectListPath));
  StickContents contents = sampleContents();
  contents.behaviours += "newer";
  const auto newer = makeTree(*sampleConfig(), contents);
  EXPECT_EQ(asFiles(*formerFiles(*newer, root)),
            (Files{{kObjectListPath, kFormer.at(kObjectListPath)}}));
}

TEST(FormerFiles, AreKeptOnceInAFolderOfShortName) {
  const std::string root = formerStick("kept");
  const StickTree former = *formerFiles(sampleTree(), root);
  EXPECT_EQ(*keepFormer(former, root, silently), "FORMER.001");
  EXPECT_EQ(filesIn(root + "/FORMER.001"), kFormer);
  EXPECT_EQ(*keepFormer(former, root, silently), "FORMER.001") << "has them already";
  put(fs::path(root) / kObjectListPath, "/MS/OPEN-R/MW/OBJS/THIRD.BIN\n");
  const std::string second = *keepFormer(*formerFiles(sampleTree(), root), root, silently);
  EXPECT_EQ(second, "FORMER.002");
  EXPECT_TRUE(isShortName(second));
  EXPECT_EQ(filesIn(root + "/FORMER.001"), kFormer);
}

Status replaceFormer(const StickTree& tree, const std::string& root, const StepObserver& step) {
  const StickTree former = *formerFiles(tree, root);
  if (!former.empty()) {
    const auto kept = keepFormer(former, root, step);
    if (!kept) return Error{kept.error()};
  }
  return writeFiles(tree, root, step);
}

// Ends before its step number `last` as if the power had gone; whether it was killed.
bool killedBefore(int last, const StickTree& tree, const std::string& root) {
  const pid_t child = fork();
  if (child == 0) {
    int steps = 0;
    const Status done = replaceFormer(tree, root, [&](const std::string&) {
      if (++steps == last) raise(SIGKILL);
    });
    _exit(done ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status);
}

// What must hold of every stick on the way: the former program has all of its files and so runs, or
// they are all in the backup, and our reader, which then runs, takes the stick only when it is
// whole.
void expectNothingLost(const std::string& root, const StickTree& tree) {
  const Files now = filesIn(root);
  for (const auto& [path, bytes] : kItsOwn) EXPECT_EQ(now.at(path), bytes);
  bool untouched = true;
  for (const auto& [path, bytes] : kFormer) untouched = untouched && now.at(path) == bytes;
  if (untouched) return;
  EXPECT_EQ(filesIn(root + "/FORMER.001"), kFormer);
  EXPECT_EQ(now.at(kObjectListPath), findFile(tree, kObjectListPath)->bytes) << "ours must run";
  bool whole = true;
  for (const auto& file : tree) {
    const auto at = now.find(file.path);
    EXPECT_TRUE(at != now.end() || file.path == kStickPath) << "ours starts without " << file.path;
    whole = whole && at != now.end() && at->second == file.bytes;
  }
  EXPECT_EQ(verdictOn(root).good(), whole);
}

TEST(FormerFiles, SurviveAnInstallationKilledAtAnyStep) {
  const StickTree tree = sampleTree();
  bool killed = true;
  int last = 1;
  for (; killed; ++last) {
    SCOPED_TRACE("killed before step " + std::to_string(last));
    const std::string root = formerStick("killed-former" + std::to_string(last));
    killed = killedBefore(last, tree, root);
    expectNothingLost(root, tree);
    ASSERT_TRUE(replaceFormer(tree, root, silently));
    EXPECT_TRUE(verdictOn(root).good());
    EXPECT_EQ(filesIn(root + "/FORMER.001"), kFormer);
    EXPECT_FALSE(fs::exists(root + "/FORMER.002") || fs::exists(root + "/" + kUnfinished));
  }
  EXPECT_EQ(last - 2, 3 + 8 + 8);  // three are kept, eight are written and renamed
}

}  // namespace
}  // namespace kelpie::stick
