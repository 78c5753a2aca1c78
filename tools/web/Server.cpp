// SPDX-License-Identifier: Apache-2.0
#include "tools/web/Server.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <utility>

#include "tools/web/Connection.h"

namespace kelpie::web {

namespace {

constexpr std::chrono::milliseconds kRest{100};

}  // namespace

using Tcp = boost::asio::ip::tcp;

struct Server::Parts {
  Shared shared;  // connections that the context still holds use it to their end
  boost::asio::io_context context{1};
  Tcp::acceptor acceptor{context};
  boost::asio::steady_timer timer{context};
  boost::asio::steady_timer rest{context};

  Parts(const ServerParams& params, Site& site)
      : shared{params, {params.address, params.origins}, site} {}

  Status listen();
  void accept();
  void acceptLater();
  void wake(double seconds, const std::function<void()>& work);
};

Status Server::Parts::listen() {
  const ServerParams& params = shared.params;
  boost::system::error_code error;
  const auto address = boost::asio::ip::make_address(params.address, error);
  if (error) return Error{params.address + ": is no address in numbers, as 127.0.0.1"};
  const Tcp::endpoint place(address, params.port);
  acceptor.open(place.protocol(), error);
  if (!error) acceptor.set_option(Tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(place, error);
  if (!error) acceptor.listen(boost::asio::socket_base::max_listen_connections, error);
  if (!error) return Done{};
  return Error{params.address + " port " + std::to_string(params.port) + ": " + error.message()};
}

void Server::Parts::accept() {
  acceptor.async_accept([this](const boost::system::error_code& error, Tcp::socket socket) {
    if (error == boost::asio::error::operation_aborted) return;
    if (error) return acceptLater();
    serve(std::move(socket), shared);
    accept();
  });
}

// No file descriptor is left, and who knocks goes on knocking: without a rest nothing else is done.
void Server::Parts::acceptLater() {
  rest.expires_after(kRest);
  rest.async_wait([this](const boost::system::error_code& error) {
    if (!error) accept();
  });
}

void Server::Parts::wake(double seconds, const std::function<void()>& work) {
  timer.expires_after(std::chrono::microseconds(static_cast<std::int64_t>(1e6 * seconds)));
  timer.async_wait([this, seconds, &work](const boost::system::error_code& error) {
    if (error) return;
    work();
    wake(seconds, work);
  });
}

Server::Server(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Server::Server(Server&& other) noexcept = default;
Server::~Server() = default;

Expected<Server> Server::open(const ServerParams& params, Site& site) {
  auto parts = std::make_unique<Parts>(params, site);
  const Status listening = parts->listen();
  if (!listening) return Error{listening.error()};
  parts->accept();
  return Server(std::move(parts));
}

std::uint16_t Server::port() const {
  boost::system::error_code ignored;
  return parts_->acceptor.local_endpoint(ignored).port();
}

std::string Server::url() const {
  const std::string& address = parts_->shared.params.address;
  const bool any = address == "0.0.0.0" || address == "::";
  const std::string host = any ? "localhost" : address;
  const bool six = host.find(':') != std::string::npos;
  return "http://" + (six ? "[" + host + "]" : host) + ":" + std::to_string(port());
}

void Server::run(double seconds, const std::function<void()>& work) {
  parts_->wake(seconds, work);
  parts_->context.run();
}

void Server::stop() { parts_->context.stop(); }

}  // namespace kelpie::web
