// SPDX-License-Identifier: Apache-2.0
// Each address of the studio, asked well and badly.
#include <nlohmann/json.hpp>

#include "robot/agent/log/LoggedTypes.h"
#include "robot/core/log/LogTopics.h"
#include "robot/core/types/FrameOutput.h"
#include "tests/core/LogFiles.h"
#include "tools/sim/world/Truth.h"
#include "tools/studio/Site.h"

namespace kelpie::studio {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class StudioSite : public LogFiles {
 protected:
  StudioSite() {
    fs::create_directories(pathOf("page/assets"));
    fs::create_directories(pathOf("red"));
    fileWith("page/index.html", "<p>page</p>");
    fileWith("page/assets/main-1a2b.js", "1");
    fileWith("secret.html", "secret");
    fileWith("red/main.py", "pass\n");
    writeLog();
    EXPECT_TRUE(shelf_.add(pathOf("red-1.mcap")));
  }
  static void writeLog() {
    auto log = LogWriter::open(pathOf("red-1.mcap"), chunksOf(1 << 20));
    log->write(kConfigTopic, TimeUs{}, *std::make_unique<agent::AgentConfig>());
    const auto input = std::make_unique<FrameInput>();
    input->time = TimeUs{1000};
    log->write(kFrameInputTopic, TimeUs{1000}, *input);
    EXPECT_TRUE(log->close());
  }
  SiteParts parts() {
    return {pathOf("page"),
            "kelpie 1",
            "out",
            shelf_,
            viewers_,
            studio_,
            link_,
            Behaviours({{"red", pathOf("red")}}),
            [this] { return playing_; }};
  }
  web::Answer ask(const std::string& method, const std::string& path,
                  const std::map<std::string, std::string>& query = {},
                  const std::string& body = "") {
    Site site(parts());
    return site.answer({method, path, query, "", body});
  }
  web::Answer get(const std::string& path, const std::map<std::string, std::string>& query = {}) {
    return ask("GET", path, query);
  }
  web::Answer order(const std::string& body) { return ask("POST", "/api/control", {}, body); }

  LogShelf shelf_;
  live::Hub viewers_{"viewers", 1};
  live::Hub studio_{"studio", 1};
  std::shared_ptr<MatchLink> link_ = std::make_shared<MatchLink>(
      *body::fieldDescription("2006"), std::vector<host::AgentHello>{{TeamColour::red, 1}});
  bool playing_ = true;
};

TEST_F(StudioSite, ThePageAndItsPartsAreFilesOfItsFolder) {
  EXPECT_EQ(get("/").file, pathOf("page/index.html"));
  EXPECT_EQ(get("/").type, "text/html; charset=utf-8");
  EXPECT_FALSE(get("/").keeps);
  EXPECT_EQ(get("/assets/main-1a2b.js").type, "text/javascript; charset=utf-8");
  EXPECT_TRUE(get("/assets/main-1a2b.js").keeps);
  EXPECT_EQ(get("/none.html").status, 404U);
  EXPECT_EQ(get("/assets").status, 404U);
  EXPECT_EQ(get("").status, 404U);
}

TEST_F(StudioSite, NoPathLeadsOutOfThePagesFolder) {
  for (const std::string& path :
       {std::string("/../secret.html"), std::string("/assets/../../secret.html"),
        std::string("/./../secret.html"), std::string("../secret.html"),
        std::string("//../secret.html"), std::string("/assets/..//../secret.html"),
        std::string("/..\\secret.html"), pathOf("secret.html"), "/" + pathOf("secret.html"),
        "//" + pathOf("secret.html"), std::string("/.."), std::string("/../"),
        std::string("/../page/index.html"), std::string("/etc/passwd"),
        std::string("//etc/passwd")})
    EXPECT_EQ(get(path).status, 404U) << path;
}

TEST_F(StudioSite, APageThatIsNotBuiltSaysHow) {
  fs::remove(pathOf("page/index.html"));
  EXPECT_EQ(get("/").status, 503U);
  EXPECT_NE(get("/").text.find("tools/build studio"), std::string::npos);
}

TEST_F(StudioSite, TheSessionTellsOfLogsAndMatch) {
  const json session = json::parse(get("/api/session").text);
  EXPECT_EQ(session.at("version"), "kelpie 1");
  EXPECT_EQ(session.at("logs").size(), 1U);
  EXPECT_EQ(session.at("logs")[0].at("name"), "red-1.mcap");
  EXPECT_EQ(session.at("logs")[0].at("url"), "/logs/0");
  EXPECT_EQ(session.at("live").at("title"), "out");
  EXPECT_EQ(session.at("live").at("playing"), true);
  EXPECT_EQ(session.at("live").at("controls"), true);
  link_.reset();
  playing_ = false;
  const json other = json::parse(get("/api/session").text).at("live");
  EXPECT_EQ(other.at("playing"), false);
  EXPECT_EQ(other.at("controls"), false);
}

TEST_F(StudioSite, ALogIsItsFileAndWhatIsNoLogIsNotFound) {
  EXPECT_EQ(get("/logs/0").file, pathOf("red-1.mcap"));
  for (const char* path : {"/logs/", "/logs/1", "/logs/-1", "/logs/x", "/logs/0x0", "/logs/0 ",
                           "/logs/99999999999999999999", "/logs/0/", "/logs/../0a", "/logs/+0"})
    EXPECT_EQ(get(path).status, 404U) << path;
  fs::remove(pathOf("red-1.mcap"));
  EXPECT_EQ(get("/logs/0").status, 404U);
}

TEST_F(StudioSite, TheClassesOfAFrameAreAPicture) {
  const web::Answer answer = get("/api/classes/0", {{"time", "1000"}});
  ASSERT_EQ(answer.status, 200U) << answer.text;
  EXPECT_EQ(answer.type, "image/png");
  EXPECT_EQ(contentOf(answer.file).substr(1, 3), "PNG");
}

TEST_F(StudioSite, ClassesOfNoFrameAreNotFound) {
  EXPECT_EQ(get("/api/classes/0").status, 404U);
  EXPECT_EQ(get("/api/classes/1", {{"time", "1000"}}).status, 404U);
  for (const char* time : {"", "x", "1.5", "999", "1001", "-1", "9223372036854775807",
                           "-9223372036854775808", "99999999999999999999"})
    EXPECT_EQ(get("/api/classes/0", {{"time", time}}).status, 404U) << time;
}

TEST_F(StudioSite, TheBodyIsJson) {
  EXPECT_EQ(get("/api/body").type, "application/json");
  EXPECT_GT(json::parse(get("/api/body").text).at("links").size(), 10U);
}

TEST_F(StudioSite, AnOrderReachesTheMatch) {
  EXPECT_EQ(order(R"({"do": "pause"})").status, 200U);
  EXPECT_EQ(order(R"({"do": "ball", "x": 100, "y": 200})").status, 200U);
  EXPECT_EQ(link_->nextOrder(), "pause");
  EXPECT_EQ(link_->nextOrder(), "ball 100,200");
  EXPECT_EQ(link_->nextOrder(), "");
}

TEST_F(StudioSite, AnOrderThatCannotBeObeyedIsRefusedWithAReason) {
  for (const char* body :
       {"", "pause", "{}", R"({"do": "halt"})", R"({"do": "ball", "x": -1, "y": 0})",
        R"({"do": "robot", "team": "blue", "player": 1, "x": 100, "y": 100, "heading_deg": 0})"}) {
    const web::Answer answer = order(body);
    EXPECT_EQ(answer.status, 400U) << body;
    EXPECT_FALSE(json::parse(answer.text).at("error").get<std::string>().empty()) << body;
  }
  EXPECT_EQ(link_->nextOrder(), "");
}

TEST_F(StudioSite, OrdersThatNobodyTakesDoNotPileUp) {
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(order(R"({"do": "pause"})").status, 200U);
  EXPECT_EQ(order(R"({"do": "pause"})").status, 400U);
  link_->nextOrder();
  EXPECT_EQ(order(R"({"do": "pause"})").status, 200U);
}

TEST_F(StudioSite, LinesThatNobodyTakesDoNotPileUp) {
  for (int i = 0; i < 2000; ++i) link_->say("line");
  EXPECT_EQ(link_->takeLines().size(), 1000U);
  EXPECT_TRUE(link_->takeLines().empty());
}

TEST_F(StudioSite, OrdersAreRefusedWhereNoMatchObeys) {
  playing_ = false;
  EXPECT_EQ(order(R"({"do": "pause"})").status, 400U);
  playing_ = true;
  link_.reset();
  EXPECT_EQ(order(R"({"do": "pause"})").status, 400U);
}

TEST_F(StudioSite, ABehaviourIsListedReadAndPut) {
  const json list = json::parse(get("/api/behaviours").text);
  EXPECT_EQ(list, json::parse(R"([{"team": "red", "path": "main.py"}])"));
  const std::map<std::string, std::string> file = {{"team", "red"}, {"path", "main.py"}};
  EXPECT_EQ(get("/api/behaviour", file).text, "pass\n");
  EXPECT_EQ(ask("PUT", "/api/behaviour", file, "changed\n").status, 200U);
  EXPECT_EQ(contentOf(pathOf("red/main.py")), "changed\n");
}

TEST_F(StudioSite, ABehaviourThatIsNoneIsRefused) {
  for (const std::map<std::string, std::string>& file :
       {std::map<std::string, std::string>{},
        {{"team", "red"}},
        {{"path", "main.py"}},
        {{"team", "red"}, {"path", "../secret.html"}},
        {{"team", "blue"}, {"path", "main.py"}}}) {
    EXPECT_EQ(get("/api/behaviour", file).status, 400U);
    EXPECT_EQ(ask("PUT", "/api/behaviour", file, "x").status, 400U);
  }
}

TEST_F(StudioSite, EachAddressHearsItsMethodsOnly) {
  for (const char* method : {"GET", "HEAD", "PUT", "DELETE", "OPTIONS"})
    EXPECT_EQ(ask(method, "/api/control").status, 405U) << method;
  for (const char* method : {"POST", "DELETE", "OPTIONS", "PATCH"})
    EXPECT_EQ(ask(method, "/api/behaviour").status, 405U) << method;
  for (const char* path : {"/", "/logs/0", "/api/session", "/api/body", "/api/behaviours", "/none"})
    for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "TRACE", ""})
      EXPECT_EQ(ask(method, path).status, 405U) << method << " " << path;
  for (const char* path : {"/", "/logs/0", "/api/session", "/api/body", "/api/behaviours"})
    EXPECT_EQ(ask("HEAD", path).status, 200U) << path;
}

TEST_F(StudioSite, AnAddressThatIsNoneIsNotFound) {
  for (const char* path :
       {"/api/", "/api/none", "/api/control/", "/api/session/x", "/none", "/logs"})
    EXPECT_EQ(get(path).status, 404U) << path;
}

TEST_F(StudioSite, ThereAreTwoRooms) {
  Site site(parts());
  EXPECT_EQ(site.roomOf("/"), &viewers_);
  EXPECT_EQ(site.roomOf("/live"), &studio_);
  for (const char* path : {"", "/live/", "/x", "/live/..", "//"})
    EXPECT_EQ(site.roomOf(path), nullptr) << path;
}

}  // namespace
}  // namespace kelpie::studio
