// SPDX-License-Identifier: Apache-2.0
// A server at a free port with a small site: files of a folder, an echo of what is posted, and a
// room that echoes and tells all who are in it.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

#include "tests/web/Client.h"
#include "tools/web/Server.h"

namespace kelpie::web {

namespace fs = std::filesystem;

class EchoRoom : public Room {
 public:
  const char* protocol() const override { return "echo.v1"; }
  void enter(Peer& peer) override {
    peers_.insert(&peer);
    present = peers_.size();
    peer.sayText("welcome");
  }
  void hear(Peer& peer, const std::string& text) override { peer.sayText("echo " + text); }
  void leave(Peer& peer) override {
    peers_.erase(&peer);
    present = peers_.size();
  }
  // To all who have not too much to read already.
  void tell(const std::shared_ptr<const std::string>& bytes) {
    for (Peer* const peer : peers_) {
      most = std::max(most.load(), peer->waiting());
      if (peer->waiting() <= kMax) peer->sayBytes(bytes);
    }
  }
  static constexpr std::size_t kMax = 1U << 20;

  std::atomic<std::size_t> present{0};
  std::atomic<std::size_t> most{0};

 private:
  std::set<Peer*> peers_;
};

class EchoSite : public Site {
 public:
  Answer answer(const Request& request) override {
    if (request.method == "POST") return textAnswer(200, request.body);
    if (request.path == "/path") return textAnswer(200, request.path);
    return fileAnswer(request, (fs::temp_directory_path() / request.path.substr(1)).string(),
                      "text/plain");
  }
  Room* roomOf(const std::string& path) override { return path == "/room" ? &room : nullptr; }

  EchoRoom room;
};

class Served : public testing::Test {
 protected:
  Served() {
    std::ofstream(fs::temp_directory_path() / "page") << "0123456789";
    ServerParams params;
    params.port = 0;
    params.maxConnections = 8;
    params.maxBody = 100000;
    params.patience = 0.4;
    auto opened = Server::open(params, site_);
    EXPECT_TRUE(opened) << opened.error();
    server_ = std::make_unique<Server>(std::move(*opened));
    thread_ = std::thread([this] {
      server_->run(0.002, [this] {
        if (chats_) site_.room.tell(news_);
      });
    });
  }
  ~Served() override {
    server_->stop();
    thread_.join();
  }

  std::uint16_t port() const { return server_->port(); }
  void expectAnswers() const { EXPECT_EQ(ask(port(), "GET /page").body, "0123456789"); }
  // What is true at last; a fact that never comes is a failed test.
  static bool becomes(const std::function<bool()>& fact) {
    for (int i = 0; i < 1000 && !fact(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return fact();
  }

  EchoSite site_;
  std::unique_ptr<Server> server_;
  std::atomic<bool> chats_{false};
  std::shared_ptr<const std::string> news_ = std::make_shared<std::string>(100000, 'n');

 private:
  std::thread thread_;
};

}  // namespace kelpie::web
