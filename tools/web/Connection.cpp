// SPDX-License-Identifier: Apache-2.0
#include "tools/web/Connection.h"

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <chrono>
#include <optional>
#include <utility>

#include "tools/web/AnswerBody.h"
#include "tools/web/Target.h"
#include "tools/web/WebSocket.h"

namespace kelpie::web {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using Tcp = boost::asio::ip::tcp;
using HttpRequest = http::request<http::string_body>;
using HttpAnswer = http::response<AnswerBody>;

// Nothing is loaded from elsewhere, nobody frames the page, and a page of another server gets
// nothing of ours.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; "
    "connect-src 'self' ws://127.0.0.1:* ws://localhost:*; worker-src 'self'; base-uri 'none'; "
    "form-action 'none'; frame-ancestors 'none'";

std::string textOf(beast::string_view view) { return {view.data(), view.size()}; }

void addHeaders(const Answer& answer, HttpAnswer& to) {
  to.set(http::field::content_type, answer.type);
  to.set("Content-Security-Policy", kPolicy);
  to.set("X-Content-Type-Options", "nosniff");
  to.set("Referrer-Policy", "no-referrer");
  to.set("Cross-Origin-Resource-Policy", "same-origin");
  to.set(http::field::cache_control,
         answer.keeps ? "public, max-age=31536000, immutable" : "no-store");
  if (!answer.file.empty()) to.set(http::field::accept_ranges, "bytes");
  const std::string size = std::to_string(answer.size);
  if (answer.status == 206)
    to.set(http::field::content_range, "bytes " + std::to_string(answer.first) + "-" +
                                           std::to_string(answer.first + answer.count - 1) + "/" +
                                           size);
  if (answer.status == 416) to.set(http::field::content_range, "bytes */" + size);
}

Request requestOf(const HttpRequest& from) {
  Request request;
  request.method = textOf(from.method_string());
  readTarget(textOf(from.target()), request);
  request.range = textOf(from[http::field::range]);
  request.body = from.body();
  return request;
}

class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(Tcp::socket socket, Shared& shared) : stream_(std::move(socket)), shared_(shared) {
    ++shared_.connections;
  }
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;
  ~HttpConnection() { --shared_.connections; }

  void read();
  void refuse(unsigned status, const std::string& why);

 private:
  void take(const beast::error_code& error);
  bool upgrade();
  void reply();
  void send(Answer answer, bool withBody);
  std::string trouble() const;
  void setPatience() {
    stream_.expires_after(
        std::chrono::milliseconds(static_cast<std::int64_t>(1000.0 * shared_.params.patience)));
  }

  beast::tcp_stream stream_;
  Shared& shared_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  std::optional<HttpAnswer> answer_;
};

void HttpConnection::read() {
  parser_.emplace();
  parser_->body_limit(shared_.params.maxBody);
  setPatience();
  http::async_read(stream_, buffer_, *parser_,
                   [self = shared_from_this()](const beast::error_code& error, std::size_t) {
                     self->take(error);
                   });
}

void HttpConnection::take(const beast::error_code& error) {
  if (error == http::error::body_limit) return refuse(413, "the request is too long\n");
  if (error == http::error::header_limit) return refuse(431, "the request's head is too long\n");
  if (error && error.category() == make_error_code(http::error::end_of_stream).category() &&
      error != http::error::end_of_stream && error != http::error::partial_message)
    return refuse(400, "this is no request\n");
  if (error) return;  // the peer has gone, or says nothing
  const std::string wrong = trouble();
  if (!wrong.empty()) return refuse(403, wrong);
  if (!upgrade()) reply();
}

// Why nobody at that name, or of that page, is answered; empty: somebody is.
std::string HttpConnection::trouble() const {
  const auto& head = parser_->get();
  const std::string host = textOf(head[http::field::host]);
  if (!shared_.guard.isHost(host)) return "this server is not called " + host.substr(0, 80) + "\n";
  const std::string origin = textOf(head[http::field::origin]);
  if (!shared_.guard.isOrigin(origin, host))
    return "pages of " + origin.substr(0, 80) + " may not ask here (--origin allows one)\n";
  return {};
}

bool HttpConnection::upgrade() {
  if (!beast::websocket::is_upgrade(parser_->get())) return false;
  const Request request = requestOf(parser_->get());
  Room* const room = shared_.site.roomOf(request.path);
  if (room == nullptr) return false;
  if (!offers(parser_->get(), room->protocol())) {
    refuse(400, std::string("this WebSocket speaks ") + room->protocol() + "\n");
    return true;
  }
  stream_.expires_never();
  enterRoom(stream_.release_socket(), parser_->release(), *room, shared_);
  return true;
}

void HttpConnection::reply() {
  const Request request = requestOf(parser_->get());
  const bool head = request.method == "HEAD";
  send(shared_.site.answer(request), !head);
}

void HttpConnection::refuse(unsigned status, const std::string& why) {
  Answer answer = textAnswer(status, why);
  if (parser_) parser_->get().keep_alive(false);
  send(std::move(answer), true);
}

void HttpConnection::send(Answer answer, bool withBody) {
  answer_.emplace();
  answer_->result(answer.status);
  addHeaders(answer, *answer_);
  AnswerBody::value_type& body = answer_->body();
  body.count = answer.count;
  if (!answer.file.empty()) {
    body.file.open(answer.file, std::ios::binary);
    body.file.seekg(static_cast<std::streamoff>(answer.first));
  }
  body.text = std::move(answer.text);
  answer_->keep_alive(parser_ && parser_->get().keep_alive());
  answer_->content_length(AnswerBody::size(body));
  if (!withBody) body = {};
  setPatience();
  http::async_write(stream_, *answer_,
                    [self = shared_from_this()](const beast::error_code& error, std::size_t) {
                      if (!error && self->answer_->keep_alive()) return self->read();
                      beast::error_code ignored;
                      self->stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
                    });
}

}  // namespace

void serve(Tcp::socket socket, Shared& shared) {
  const bool full = shared.connections >= shared.params.maxConnections;
  const auto connection = std::make_shared<HttpConnection>(std::move(socket), shared);
  if (full) return connection->refuse(503, "too many connections\n");
  connection->read();
}

}  // namespace kelpie::web
