// SPDX-License-Identifier: Apache-2.0
// A client that says whatever bytes a test wants to a server on this machine, and waits at most
// some seconds for what it hears. Speaks as much of RFC 6455 as the tests need.
#pragma once

#include <cstdint>
#include <string>

namespace kelpie::web {

class Client {
 public:
  // `buffer`: bytes that the kernel takes for a client that does not read; 0: as usual.
  explicit Client(std::uint16_t port, int buffer = 0);
  Client(Client&& other) noexcept;
  Client(const Client&) = delete;
  ~Client();

  // False: the other end has closed.
  bool send(const std::string& bytes);
  // Says that it has no more to say.
  void finish();
  // Up to and with `mark`, or what came before the end; a wait for too long is a failed test.
  std::string until(const std::string& mark);
  std::string bytes(std::size_t count);
  // All that comes until the other end closes.
  std::string rest() { return until(""); }

  // Asks for a WebSocket; the head of the answer. `more`: further lines of the request.
  std::string upgrade(const std::string& path, const std::string& more);
  bool sayText(const std::string& text) { return sayFrame(1, text); }
  bool sayFrame(std::uint8_t opcode, const std::string& content);
  // The content of the next frame that is neither ping nor pong; of a frame that closes, "".
  std::string frame();

 private:
  bool more();
  int socket_;
  std::string heard_;
};

// The status and the body of an answer to one request, and its head.
struct Heard {
  int status = 0;
  std::string head;
  std::string body;
};
Heard heardFrom(const std::string& answer);
// Of a client of its own: "GET /a" without what follows.
Heard ask(std::uint16_t port, const std::string& request, const std::string& more = "",
          const std::string& body = "");

constexpr const char* kOffer = "Sec-WebSocket-Protocol: echo.v1\r\n";

}  // namespace kelpie::web
