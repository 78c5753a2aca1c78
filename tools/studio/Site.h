// SPDX-License-Identifier: Apache-2.0
// What the studio's page asks for: itself, recorded logs, the robot's body, a live match and
// orders to it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "tools/live/Hub.h"
#include "tools/studio/Behaviours.h"
#include "tools/studio/LogShelf.h"
#include "tools/studio/MatchLink.h"
#include "tools/web/Site.h"

namespace kelpie::studio {

struct SiteParts {
  std::string page;     // folder of the built page
  std::string version;  // of the program
  std::string title;    // of the live match; empty: none can be
  LogShelf& shelf;
  live::Hub& viewers;
  live::Hub& studio;
  std::shared_ptr<MatchLink> link;  // null: the match is not ours to order about
  Behaviours behaviours;
  std::function<bool()> playing;  // a live match, now
};

class Site : public web::Site {
 public:
  explicit Site(SiteParts parts) : parts_(std::move(parts)) {}

  web::Answer answer(const web::Request& request) override;
  // "/live" is the studio's, "/" that of other viewers.
  web::Room* roomOf(const std::string& path) override;

 private:
  web::Answer page(const web::Request& request) const;
  web::Answer session() const;
  web::Answer log(const web::Request& request) const;
  web::Answer frame(const web::Request& request) const;
  web::Answer control(const web::Request& request) const;
  web::Answer listBehaviours() const;
  web::Answer behaviour(const web::Request& request) const;

  SiteParts parts_;
};

}  // namespace kelpie::studio
