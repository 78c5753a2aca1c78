// SPDX-License-Identifier: Apache-2.0
#include "tools/studio/Site.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "robot/core/NumberText.h"
#include "tools/cli/JsonText.h"
#include "tools/studio/BodyJson.h"
#include "tools/studio/FrameVision.h"
#include "tools/studio/OrderJson.h"

namespace kelpie::studio {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using web::Answer;
using web::Request;
using web::textAnswer;

constexpr const char* kNoPage =
    "The studio's page is not built: tools/build studio builds it (it needs node and npm, which it "
    "installs from Debian).\n";

Answer jsonAnswer(const json& value, unsigned status = 200) {
  Answer answer = textAnswer(status, cli::jsonText(value) + "\n");
  answer.type = "application/json";
  return answer;
}

Answer refusal(const std::string& why) { return jsonAnswer({{"error", why}}, 400); }

std::string typeOf(const std::string& path) {
  const std::string ending = fs::path(path).extension().string();
  if (ending == ".html") return "text/html; charset=utf-8";
  if (ending == ".js") return "text/javascript; charset=utf-8";
  if (ending == ".css") return "text/css; charset=utf-8";
  if (ending == ".svg") return "image/svg+xml";
  if (ending == ".png") return "image/png";
  if (ending == ".wasm") return "application/wasm";
  return "application/octet-stream";
}

// The log that a path such as /logs/3 names.
const ShelvedLog* logOf(const std::string& path, const std::vector<ShelvedLog>& logs) {
  const auto number = numberFrom<std::int64_t>(path.substr(path.rfind('/') + 1));
  if (!number || *number < 0 || *number >= static_cast<std::int64_t>(logs.size())) return nullptr;
  return &logs[static_cast<std::size_t>(*number)];
}

bool startsWith(const std::string& text, const std::string& with) {
  return text.compare(0, with.size(), with) == 0;
}

}  // namespace

web::Room* Site::roomOf(const std::string& path) {
  if (path == "/live") return &parts_.studio;
  return path == "/" ? &parts_.viewers : nullptr;
}

Answer Site::answer(const Request& request) {
  const std::string& path = request.path;
  const bool reads = request.method == "GET" || request.method == "HEAD";
  if (path == "/api/control") return control(request);
  if (path == "/api/behaviour") return behaviour(request);
  if (!reads) return textAnswer(405, "only GET is answered here\n");
  if (path == "/api/session") return session();
  if (path == "/api/behaviours") return listBehaviours();
  if (path == "/api/body") {
    Answer answer = textAnswer(200, bodyJson());
    answer.type = "application/json";
    return answer;
  }
  if (startsWith(path, "/logs/")) return log(request);
  if (startsWith(path, "/api/classes/") || startsWith(path, "/api/refused/")) return frame(request);
  if (startsWith(path, "/api/")) return textAnswer(404, "there is nothing of that name\n");
  return page(request);
}

// Only names below the page's folder, whatever a path says.
Answer Site::page(const Request& request) const {
  const fs::path name = request.path == "/" ? "index.html" : fs::path(request.path).relative_path();
  for (const fs::path& part : name)
    if (part == "..") return textAnswer(404, "there is no such file\n");
  const fs::path file = fs::path(parts_.page) / name;
  std::error_code error;
  if (request.path == "/" && !fs::exists(file, error)) return textAnswer(503, kNoPage);
  Answer answer = web::fileAnswer(request, file.string(), typeOf(file.string()));
  answer.keeps = startsWith(request.path, "/assets/");  // Vite names them by their content
  return answer;
}

Answer Site::session() const {
  json logs = json::array();
  for (const ShelvedLog& log : parts_.shelf.logs())
    logs.push_back({{"name", log.name},
                    {"url", "/logs/" + std::to_string(logs.size())},
                    {"bytes", log.bytes},
                    {"notes", log.notes}});
  json live;
  if (!parts_.title.empty())
    live = {{"url", "/live"},
            {"title", parts_.title},
            {"playing", parts_.playing()},
            {"controls", parts_.link != nullptr},
            {"behaviours", !parts_.behaviours.none()}};
  return jsonAnswer(
      {{"version", parts_.version}, {"logs", logs}, {"live", live}, {"body", "/api/body"}});
}

Answer Site::log(const Request& request) const {
  const ShelvedLog* const log = logOf(request.path, parts_.shelf.logs());
  if (log == nullptr) return textAnswer(404, "there is no such log\n");
  return web::fileAnswer(request, log->path, "application/octet-stream");
}

Answer Site::frame(const Request& request) const {
  const ShelvedLog* const log = logOf(request.path, parts_.shelf.logs());
  const auto found = request.query.find("time");
  const auto time =
      found == request.query.end() ? std::nullopt : numberFrom<std::int64_t>(found->second);
  if (log == nullptr || !time) return textAnswer(404, "there is no such frame\n");
  const TimeUs at{time.value_or(0)};
  if (startsWith(request.path, "/api/classes/")) {
    const std::string picture = parts_.shelf.temporary("classes.png");
    const Status drawn = drawClasses(log->path, at, picture);
    return drawn ? web::fileAnswer({}, picture, "image/png")
                 : textAnswer(404, drawn.error() + "\n");
  }
  const auto refused = refusedJson(log->path, at);
  if (!refused) return textAnswer(404, refused.error() + "\n");
  Answer answer = textAnswer(200, *refused + "\n");
  answer.type = "application/json";
  return answer;
}

Answer Site::control(const Request& request) const {
  if (request.method != "POST") return textAnswer(405, "orders are posted\n");
  if (!parts_.link) return refusal("this match is not ours to order about");
  if (!parts_.playing()) return refusal("no match is being played");
  const auto order = orderFromJson(request.body);
  const Status taken = order ? parts_.link->order(*order) : Status(Error{order.error()});
  return taken ? jsonAnswer({{"ok", true}}) : refusal(taken.error());
}

Answer Site::listBehaviours() const {
  json files = json::array();
  for (const BehaviourFile& file : parts_.behaviours.list())
    files.push_back({{"team", file.team}, {"path", file.path}});
  return jsonAnswer(files);
}

Answer Site::behaviour(const Request& request) const {
  const auto word = [&request](const char* key) {
    const auto found = request.query.find(key);
    return found == request.query.end() ? std::string() : found->second;
  };
  const BehaviourFile file{word("team"), word("path")};
  if (request.method == "PUT") {
    const Status written = parts_.behaviours.write(file, request.body);
    return written ? jsonAnswer({{"ok", true}}) : refusal(written.error());
  }
  if (request.method != "GET") return textAnswer(405, "a behaviour is read or put\n");
  const auto text = parts_.behaviours.read(file);
  return text ? textAnswer(200, *text) : refusal(text.error());
}

}  // namespace kelpie::studio
