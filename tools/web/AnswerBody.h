// SPDX-License-Identifier: Apache-2.0
// A body of Boost.Beast for what a Site answers: a text, or a part of a file in pieces. A file that
// ends early, because somebody cuts it off meanwhile, ends the connection.
#pragma once

#include <algorithm>
#include <boost/beast/http/message.hpp>
#include <boost/optional.hpp>
#include <cstdint>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace kelpie::web {

struct AnswerBody {
  struct value_type {
    std::string text;
    std::ifstream file;  // closed: the text is the body
    std::uint64_t count = 0;
  };
  static std::uint64_t size(const value_type& body) {
    return body.file.is_open() ? body.count : body.text.size();
  }

  class writer {
   public:
    using const_buffers_type = boost::asio::const_buffer;
    using Piece = boost::optional<std::pair<const_buffers_type, bool>>;

    template <bool isRequest, class Fields>
    writer(boost::beast::http::header<isRequest, Fields>&, value_type& body)
        : body_(body), left_(size(body)) {}
    void init(boost::beast::error_code& error) { error = {}; }
    Piece get(boost::beast::error_code& error) {
      error = {};
      if (left_ == 0) return boost::none;
      if (!body_.file.is_open()) {
        left_ = 0;
        return {{boost::asio::buffer(body_.text), false}};
      }
      piece_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(left_, kPiece)));
      body_.file.read(piece_.data(), static_cast<std::streamsize>(piece_.size()));
      if (!body_.file) error = make_error_code(boost::system::errc::io_error);
      if (!body_.file) return boost::none;
      left_ -= piece_.size();
      return {{boost::asio::buffer(piece_), left_ > 0}};
    }

   private:
    static constexpr std::uint64_t kPiece = 1U << 18;  // bytes
    value_type& body_;
    std::uint64_t left_;
    std::vector<char> piece_;
  };
};

}  // namespace kelpie::web
