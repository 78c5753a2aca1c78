// SPDX-License-Identifier: Apache-2.0
// Which files of a team's folder may be read and changed, and that no others are.
#include "tests/core/LogFiles.h"
#include "tools/studio/Behaviours.h"

namespace kelpie::studio {
namespace {

namespace fs = std::filesystem;

class TeamFolders : public LogFiles {
 protected:
  TeamFolders() {
    fs::create_directories(pathOf("red/roles"));
    fs::create_directories(pathOf("blue"));
    fs::create_directories(pathOf("elsewhere"));
    for (const char* name : {"red/main.py", "red/roles/keeper.py", "blue/main.py",
                             "elsewhere/secret.py", "outside.py"})
      fileWith(name, std::string("# ") + name + "\n");
    fileWith("red/notes.txt", "not Python");
    fileWith("red/main.pyc", "not Python");
  }
  Behaviours both() const { return Behaviours({{"red", pathOf("red")}, {"blue", pathOf("blue")}}); }
  static std::vector<std::string> namesOf(const Behaviours& behaviours) {
    std::vector<std::string> names;
    for (const BehaviourFile& file : behaviours.list())
      names.push_back(file.team + " " + file.path);
    return names;
  }
};

TEST_F(TeamFolders, AreListedByTeamAndName) {
  EXPECT_EQ(namesOf(both()),
            (std::vector<std::string>{"blue main.py", "red main.py", "red roles/keeper.py"}));
  EXPECT_TRUE(Behaviours({}).none());
  EXPECT_TRUE(Behaviours({}).list().empty());
  EXPECT_TRUE(namesOf(Behaviours({{"red", pathOf("none")}})).empty());
}

TEST_F(TeamFolders, AFileIsReadAndChanged) {
  const Behaviours behaviours = both();
  const auto text = behaviours.read({"red", "roles/keeper.py"});
  ASSERT_TRUE(text);
  EXPECT_EQ(*text, "# red/roles/keeper.py\n");
  ASSERT_TRUE(behaviours.write({"red", "roles/keeper.py"}, "changed\n"));
  EXPECT_EQ(*behaviours.read({"red", "roles/keeper.py"}), "changed\n");
  ASSERT_TRUE(behaviours.write({"blue", "main.py"}, ""));
  EXPECT_EQ(*behaviours.read({"blue", "main.py"}), "");
  EXPECT_EQ(contentOf(pathOf("red/main.py")), "# red/main.py\n");
}

TEST_F(TeamFolders, NoPathLeadsOutOfThem) {
  const Behaviours behaviours = both();
  for (const std::string& path : {std::string("../outside.py"),
                                  std::string("../blue/main.py"),
                                  std::string("roles/../../outside.py"),
                                  std::string("./main.py"),
                                  std::string("roles/../main.py"),
                                  std::string("roles//keeper.py"),
                                  std::string("/main.py"),
                                  pathOf("outside.py"),
                                  pathOf("red/main.py"),
                                  std::string("/etc/passwd"),
                                  std::string(),
                                  std::string("."),
                                  std::string(".."),
                                  std::string("roles"),
                                  std::string("notes.txt"),
                                  std::string("main.pyc"),
                                  std::string("new.py"),
                                  std::string("main.py\0x", 9),
                                  std::string("MAIN.PY"),
                                  std::string("main.py/"),
                                  std::string("%2e%2e/outside.py")}) {
    EXPECT_FALSE(behaviours.read({"red", path})) << path;
    EXPECT_FALSE(behaviours.write({"red", path}, "overwritten")) << path;
  }
  EXPECT_EQ(contentOf(pathOf("outside.py")), "# outside.py\n");
  EXPECT_FALSE(fs::exists(pathOf("red/new.py")));
}

TEST_F(TeamFolders, ATeamThatDoesNotPlayHasNone) {
  const Behaviours behaviours = both();
  for (const char* team : {"", "green", "..", "red/roles", "../red"}) {
    EXPECT_FALSE(behaviours.read({team, "main.py"})) << team;
    EXPECT_FALSE(behaviours.write({team, "main.py"}, "x")) << team;
  }
}

TEST_F(TeamFolders, LinksAreNotFollowed) {
  fs::create_symlink(pathOf("outside.py"), pathOf("red/link.py"));
  fs::create_symlink(pathOf("elsewhere"), pathOf("red/linked"));
  const Behaviours behaviours = both();
  EXPECT_EQ(namesOf(behaviours).size(), 3U);
  for (const char* path :
       {"link.py", "linked/secret.py", "../outside.py", "../elsewhere/secret.py"}) {
    EXPECT_FALSE(behaviours.read({"red", path})) << path;
    EXPECT_FALSE(behaviours.write({"red", path}, "overwritten")) << path;
  }
  EXPECT_EQ(contentOf(pathOf("outside.py")), "# outside.py\n");
  EXPECT_EQ(contentOf(pathOf("elsewhere/secret.py")), "# elsewhere/secret.py\n");
}

// Some editors lay such a link beside a file that is being changed.
TEST_F(TeamFolders, ALinkToNothingHidesNoOther) {
  fs::create_symlink("somebody@somewhere.1234", pathOf("red/.#main.py"));
  fs::create_symlink(pathOf("red/loop.py"), pathOf("red/loop.py"));
  fs::create_directory(pathOf("red/folder.py"));
  EXPECT_EQ(namesOf(both()).size(), 3U);
}

}  // namespace
}  // namespace kelpie::studio
