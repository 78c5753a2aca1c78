// SPDX-License-Identifier: Apache-2.0
#include "tools/web/WebSocket.h"

#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <sstream>
#include <utility>

namespace kelpie::web {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = boost::asio::ip::tcp;

class WebSocket : public Peer, public std::enable_shared_from_this<WebSocket> {
 public:
  WebSocket(Tcp::socket socket, Room& room, Shared& shared)
      : stream_(std::move(socket)), room_(room), shared_(shared) {
    ++shared_.connections;
  }
  WebSocket(const WebSocket&) = delete;
  WebSocket& operator=(const WebSocket&) = delete;
  ~WebSocket() override {
    if (inside_) room_.leave(*this);
    --shared_.connections;
  }

  void accept(http::request<http::string_body> request);
  void sayText(std::string text) override {
    say({std::make_shared<const std::string>(std::move(text)), true});
  }
  void sayBytes(std::shared_ptr<const std::string> bytes) override {
    say({std::move(bytes), false});
  }
  std::size_t waiting() const override { return waiting_; }

 private:
  struct Said {
    std::shared_ptr<const std::string> bytes;
    bool text;
  };
  void say(Said said);
  void sendNext();
  void read();

  websocket::stream<beast::tcp_stream> stream_;
  Room& room_;
  Shared& shared_;
  bool inside_ = false;
  beast::flat_buffer heard_;
  std::deque<Said> queue_;  // the first is being sent
  std::size_t waiting_ = 0;
};

void WebSocket::accept(http::request<http::string_body> request) {
  auto timeout = websocket::stream_base::timeout::suggested(beast::role_type::server);
  timeout.idle_timeout = std::chrono::seconds(60);  // without an answer to a ping
  timeout.keep_alive_pings = true;
  stream_.set_option(timeout);
  stream_.read_message_max(shared_.params.maxBody);
  stream_.auto_fragment(false);
  stream_.set_option(websocket::stream_base::decorator([this](websocket::response_type& answer) {
    answer.set(http::field::sec_websocket_protocol, room_.protocol());
  }));
  const auto kept = std::make_shared<http::request<http::string_body>>(std::move(request));
  stream_.async_accept(*kept, [self = shared_from_this(), kept](const beast::error_code& error) {
    if (error) return;
    self->inside_ = true;
    self->room_.enter(*self);
    self->read();
  });
}

void WebSocket::read() {
  stream_.async_read(heard_,
                     [self = shared_from_this()](const beast::error_code& error, std::size_t) {
                       if (error) return;
                       const bool text = self->stream_.got_text();
                       const std::string said = beast::buffers_to_string(self->heard_.data());
                       self->heard_.consume(self->heard_.size());
                       if (text) self->room_.hear(*self, said);
                       self->read();
                     });
}

// Who takes none of a great many answers is not waited for.
void WebSocket::say(Said said) {
  if (waiting_ > shared_.params.maxWaiting) return beast::get_lowest_layer(stream_).close();
  waiting_ += said.bytes->size();
  queue_.push_back(std::move(said));
  if (queue_.size() == 1) sendNext();
}

void WebSocket::sendNext() {
  stream_.text(queue_.front().text);
  stream_.async_write(boost::asio::buffer(*queue_.front().bytes),
                      [self = shared_from_this()](const beast::error_code& error, std::size_t) {
                        if (error) return;
                        self->waiting_ -= self->queue_.front().bytes->size();
                        self->queue_.pop_front();
                        if (!self->queue_.empty()) self->sendNext();
                      });
}

}  // namespace

bool offers(const http::request<http::string_body>& request, const std::string& protocol) {
  const auto list = request[http::field::sec_websocket_protocol];
  std::istringstream words(std::string(list.data(), list.size()));
  for (std::string word; std::getline(words, word, ',');) {
    const auto first = word.find_first_not_of(' ');
    const auto last = word.find_last_not_of(' ');
    if (first != std::string::npos && word.substr(first, last - first + 1) == protocol) return true;
  }
  return false;
}

void enterRoom(Tcp::socket socket, http::request<http::string_body> request, Room& room,
               Shared& shared) {
  std::make_shared<WebSocket>(std::move(socket), room, shared)->accept(std::move(request));
}

}  // namespace kelpie::web
