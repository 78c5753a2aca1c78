// SPDX-License-Identifier: Apache-2.0
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <set>

#include "robot/stick/StdioFiles.h"
#include "robot/stick/StickReader.h"
#include "tests/stick/Sticks.h"
#include "tools/stick/medium/StickDifference.h"
#include "tools/stick/medium/StickFolder.h"
#include "tools/stick/medium/StickImage.h"

namespace kelpie::stick {
namespace {

std::string folder(const std::string& name) {
  return (fs::path(testing::TempDir()) / name).string();
}

std::map<std::string, std::string> filesIn(const std::string& root) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), root).string()] = *readWhole(entry.path().string());
  return files;
}

StickTree otherTree() {
  auto config = sampleConfig();
  config->player = 1;
  StickContents contents = sampleContents();
  contents.object += "newer";
  contents.behaviours += "newer";
  return *makeTree(*config, contents);
}

bool loadsAs(const std::string& root, int player) {
  StdioFiles files(root.c_str());
  const auto config = std::make_unique<agent::AgentConfig>();
  return std::make_unique<StickReader>(files)->load(*config).good() && config->player == player;
}

TEST(StickTree, HasNamesInEightAndThreeUpperCase) {
  for (const auto& file : sampleTree()) EXPECT_TRUE(isShortName(file.path)) << file.path;
  for (const auto* wrong :
       {"a.bin", "LONGNAMES.BIN", "A.LONG", "A..B", "", "A/", "/A", "A B", "A.B.C"})
    EXPECT_FALSE(isShortName(wrong)) << wrong;
  EXPECT_TRUE(isShortName(kUnfinished));
}

// They lie in one folder until they are all written.
TEST(StickTree, HasNamesThatDifferWithoutTheirFolders) {
  std::set<std::string> names;
  for (const auto& file : sampleTree()) names.insert(fs::path(file.path).filename().string());
  EXPECT_EQ(names.size(), sampleTree().size());
}

TEST(StickTree, IsRefusedBeyondTheStick) {
  StickContents contents = sampleContents();
  contents.object.resize(kLargestTree);
  EXPECT_FALSE(makeTree(*sampleConfig(), contents));
}

TEST(StickTree, ListsEveryOtherFileOfTheStick) {
  const StickTree tree = sampleTree();
  TreeFiles files(tree);
  const auto reader = std::make_unique<StickReader>(files);
  EXPECT_TRUE(reader->check().good());
  EXPECT_EQ(reader->list().files.size() + 1, tree.size());
}

TEST(StickFolder, WrittenTwiceIsIdentical) {
  ASSERT_TRUE(writeFiles(sampleTree(), folder("once"), silently));
  ASSERT_TRUE(writeFiles(sampleTree(), folder("twice"), silently));
  EXPECT_EQ(filesIn(folder("once")), filesIn(folder("twice")));
  EXPECT_EQ(filesIn(folder("once")).size(), sampleTree().size());
  EXPECT_TRUE(loadsAs(folder("once"), 3));
}

TEST(StickFolder, WritesOnlyWhatDiffers) {
  const std::string root = mountedStick("again");
  ASSERT_TRUE(writeFiles(sampleTree(), root, silently));
  int steps = 0;
  ASSERT_TRUE(writeFiles(sampleTree(), root, [&](const std::string&) { ++steps; }));
  EXPECT_EQ(steps, 0);
}

TEST(StickFolder, RefusesAMountThatIsNoProgrammingStick) {
  const StickTree tree = sampleTree();
  EXPECT_FALSE(checkMount(tree, folder("no-such")));
  fs::create_directories(folder("camera/DCIM"));
  EXPECT_NE(checkMount(tree, folder("camera")).error().find("APERIOS.GZ"), std::string::npos);
  const std::string half = mountedStick("half");
  fs::remove_all(half + "/OPEN-R/SYSTEM/OBJS");
  EXPECT_NE(checkMount(tree, half).error().find("SYSTEM/OBJS"), std::string::npos);
  EXPECT_NE(checkMount(tree, mountedStick("mute", false)).error().find("radio"), std::string::npos);
  EXPECT_TRUE(checkMount(tree, mountedStick("right")));
}

TEST(StickFolder, AFolderWithAnEarlierObjectIsNotMixedWithANewStick) {
  ASSERT_TRUE(writeFiles(sampleTree(), folder("old"), silently));
  StickContents contents = sampleContents();
  contents.object.clear();
  const auto without = makeTree(*sampleConfig(), contents);
  EXPECT_NE(checkFolder(*without, folder("old")).error().find("AGENT.BIN"), std::string::npos);
  EXPECT_FALSE(checkFolder(*without, mountedStick("sony")));
}

// Installs in a process that is killed before its step number `last`; how it ended.
int installUntil(const StickTree& tree, const std::string& root, int last) {
  const pid_t child = fork();
  if (child == 0) {
    int steps = 0;
    const Status done = writeFiles(tree, root, [&](const std::string&) {
      if (++steps == last) raise(SIGKILL);
    });
    _exit(done ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

// Until the first new name the earlier stick plays; then the robot refuses until all have changed.
TEST(StickFolder, AnInstallationKilledAnywhereLosesNothing) {
  const StickTree old = sampleTree();
  const StickTree wanted = otherTree();
  int killed = 0;
  for (int last = 1;; ++last) {
    const std::string root = mountedStick("killed" + std::to_string(last));
    const auto sony = filesIn(root);
    ASSERT_TRUE(writeFiles(old, root, silently));
    const int status = installUntil(wanted, root, last);
    auto files = filesIn(root);
    for (const auto& [path, bytes] : sony) EXPECT_EQ(files[path], bytes) << path;
    for (const auto& file : old)
      EXPECT_TRUE(files[file.path] == file.bytes ||
                  files[file.path] == findFile(wanted, file.path)->bytes);
    EXPECT_TRUE(last > 4 || loadsAs(root, 3)) << "step " << last;
    ASSERT_TRUE(writeFiles(wanted, root, silently));
    EXPECT_TRUE(loadsAs(root, 1));
    EXPECT_EQ(filesIn(root).size(), sony.size() + wanted.size());
    if (!WIFSIGNALED(status)) break;
    ++killed;
  }
  EXPECT_EQ(killed, 6);  // three files differ: three are written, three are renamed
}

// A disk that is full half way through the largest file.
TEST(StickFolder, AFullDiskLeavesTheEarlierStick) {
  const std::string root = mountedStick("full");
  ASSERT_TRUE(writeFiles(sampleTree(), root, silently));
  const auto before = filesIn(root);
  const StickTree wanted = otherTree();
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit = {100000, 100000};
    setrlimit(RLIMIT_FSIZE, &limit);
    _exit(writeFiles(wanted, root, silently) ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_EQ(filesIn(root), before);
  EXPECT_TRUE(loadsAs(root, 3));
}

// Writes to a stick whose n-th rename fails, since what should be renamed is gone.
std::string complaintOfRename(int n, const StickTree& tree, const std::string& root) {
  int renames = 0;
  const Status done = writeFiles(tree, root, [&](const std::string& step) {
    if (step.rfind("rename ", 0) == 0 && ++renames == n) fs::remove_all(root + "/" + kUnfinished);
  });
  EXPECT_EQ(renames, n);
  return done.error();
}

TEST(StickFolder, ARenameThatFailsFirstLeavesTheEarlierStickAndSaysSo) {
  const std::string root = mountedStick("first-rename");
  ASSERT_TRUE(writeFiles(sampleTree(), root, silently));
  const auto before = filesIn(root);
  const std::string reported = complaintOfRename(1, otherTree(), root);
  EXPECT_NE(reported.find("are as they were"), std::string::npos) << reported;
  EXPECT_EQ(filesIn(root), before);
  EXPECT_TRUE(loadsAs(root, 3));
}

// What is new takes its place first and goes again; STICK.BIN is the last of three.
TEST(StickFolder, ARenameThatFailsBeforeAFileIsReplacedTakesTheNewOnesAway) {
  const std::string root = mountedStick("new-rename");
  put(fs::path(root) / kObjectListPath, "another's");
  const auto before = filesIn(root);
  for (int n = 2; n <= 6; ++n) {
    EXPECT_NE(complaintOfRename(n, sampleTree(), root).find("are as they were"), std::string::npos);
    EXPECT_EQ(filesIn(root), before);
  }
}

TEST(StickFolder, ARenameThatFailsLaterLeavesAMixtureAndSaysSo) {
  const std::string root = mountedStick("late-rename");
  ASSERT_TRUE(writeFiles(sampleTree(), root, silently));
  const std::string reported = complaintOfRename(2, otherTree(), root);
  EXPECT_NE(reported.find("a mixture that no robot plays"), std::string::npos) << reported;
  EXPECT_FALSE(loadsAs(root, 3) || loadsAs(root, 1));
  ASSERT_TRUE(writeFiles(otherTree(), root, silently));
  EXPECT_TRUE(loadsAs(root, 1));
}

TEST(StickFolder, WritesOverNoNameButTheTreesAndLeavesNoneBehind) {
  const std::string root = mountedStick("own-names");
  const char* own[] = {"OPEN-R/MW/CONF/OBJECT.NEW", "OPEN-R/MW/DATA/P/STICK.NEW", "FORMER.NEW/A"};
  for (const auto* path : own) put(fs::path(root) / path, "the user's own");
  put(fs::path(root) / kUnfinished / "STICK.BIN", "of an installation that was stopped");
  ASSERT_TRUE(writeFiles(sampleTree(), root, silently));
  for (const auto* path : own) EXPECT_TRUE(fs::exists(root + "/" + path)) << path;
  EXPECT_FALSE(fs::exists(root + "/" + kUnfinished));
}

TEST(StickDifference, NamesEachFileAndTheFirstParameterButNoKeys) {
  const std::string root = mountedStick("differs");
  ASSERT_TRUE(writeFiles(sampleTree(), root, silently));
  auto config = sampleConfig();
  config->player = 1;
  StickContents contents = sampleContents();
  contents.wlan = "ESSID=secretnet\nETHER_IP=10.0.1.9\n";
  std::string all;
  for (const auto& line : differenceLines(*makeTree(*config, contents), *config, root))
    all += line + "\n";
  EXPECT_NE(all.find("same     OPEN-R/MW/CONF/OBJECT.CFG"), std::string::npos) << all;
  EXPECT_NE(all.find("changed  OPEN-R/SYSTEM/CONF/WLANCONF.TXT"), std::string::npos) << all;
  EXPECT_NE(all.find("player: 3 != 1"), std::string::npos) << all;
  EXPECT_EQ(all.find("secret"), std::string::npos) << all;
  fs::remove(root + "/" + kScriptsPath);
  all = differenceLines(sampleTree(), *config, root).back();
  EXPECT_NE(all.find("PYCODE.ZIP: is missing"), std::string::npos) << all;
}

TEST(StickImage, HasTheSameBytesAtAnotherTime) {
  if (findProgram({"mformat"}).empty()) GTEST_SKIP() << "mtools is not installed";
  const Status first = writeImage(sampleTree(), folder("a.img"));
  ASSERT_TRUE(first) << first.error();
  sleep(3);  // FAT counts in two seconds
  ASSERT_TRUE(writeImage(sampleTree(), folder("b.img")));
  EXPECT_EQ(*readWhole(folder("a.img")), *readWhole(folder("b.img")));
  EXPECT_LE(fs::file_size(folder("a.img")), 8000000U);
  EXPECT_FALSE(fs::exists(folder("a.img.part")));
}

}  // namespace
}  // namespace kelpie::stick
