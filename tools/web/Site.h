// SPDX-License-Identifier: Apache-2.0
// What a web server of ours asks for: an answer to each request, and somebody at the other end of
// each WebSocket. All calls come from the server's one thread, so that no locks are needed; none
// may wait.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace kelpie::web {

struct Request {
  std::string method;                        // "GET"
  std::string path;                          // decoded, without the query: "/logs/0"
  std::map<std::string, std::string> query;  // decoded
  std::string range;                         // as sent, empty: none
  std::string body;
};

// A text, or bytes of a file, which are read as the peer takes them.
struct Answer {
  unsigned status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string text;
  std::string file;         // path; empty: the text is the answer
  std::uint64_t first = 0;  // of the file's bytes
  std::uint64_t count = 0;
  std::uint64_t size = 0;  // of the whole file, for a part of it
  bool keeps = false;      // the peer may keep it: its name changes with its content
};

Answer textAnswer(unsigned status, std::string text);
// The whole file, or what the request's range asks of it; 404 where there is no such file, 416 for
// a range beyond it.
Answer fileAnswer(const Request& request, const std::string& path, const std::string& type);

// Who is at the other end of a WebSocket.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual void sayText(std::string text) = 0;
  virtual void sayBytes(std::shared_ptr<const std::string> bytes) = 0;
  // Bytes that were said and are not sent yet.
  virtual std::size_t waiting() const = 0;
};

// Those who are at the WebSockets of one path.
class Room {
 public:
  virtual ~Room() = default;
  virtual const char* protocol() const = 0;  // the subprotocol that a peer must offer
  virtual void enter(Peer& peer) = 0;
  virtual void hear(Peer& peer, const std::string& text) = 0;
  virtual void leave(Peer& peer) = 0;
};

class Site {
 public:
  virtual ~Site() = default;
  virtual Answer answer(const Request& request) = 0;
  virtual Room* roomOf(const std::string& path) = 0;  // null: there is none
};

}  // namespace kelpie::web
