// SPDX-License-Identifier: Apache-2.0
// Which names and pages are answered.
#include <gtest/gtest.h>

#include "tools/web/Guard.h"

namespace kelpie::web {
namespace {

const Guard kGuard{"127.0.0.1", {"https://app.foxglove.dev"}};

TEST(Guard, AddressesInNumbersAndLocalhostAreHosts) {
  for (const char* host : {"127.0.0.1", "127.0.0.1:8765", "192.168.1.20:80", "localhost",
                           "localhost:8765", "[::1]", "[::1]:8765", "[fe80::1234]:1"})
    EXPECT_TRUE(kGuard.isHost(host)) << host;
}

TEST(Guard, NamesThatMayBeMadeToLeadHereAreNoHosts) {
  for (const char* host : {"evil.example",
                           "evil.example:8765",
                           "localhost.evil.example",
                           "127.0.0.1.evil.example",
                           "127.0.0.1.nip.io:8765",
                           "localhost.",
                           "xlocalhost",
                           "2130706433",
                           "0x7f000001",
                           "127.1",
                           "evil.example@127.0.0.1",
                           "localhost@evil.example:80",
                           "::1",
                           "1::",
                           "[::1",
                           "[]",
                           "",
                           ":8765",
                           " localhost",
                           "[evil.example]:8765",
                           "[::1.evil.example]"})
    EXPECT_FALSE(kGuard.isHost(host)) << host;
}

TEST(Guard, TheNameThatTheServerListensAtIsAHost) {
  const Guard guard{"kelpie.example", {}};
  EXPECT_TRUE(guard.isHost("kelpie.example:8765"));
  EXPECT_FALSE(guard.isHost("a.kelpie.example:8765"));
}

TEST(Guard, ProgramsAndTheServersOwnPageMayAsk) {
  EXPECT_TRUE(kGuard.isOrigin("", "127.0.0.1:8765"));
  EXPECT_TRUE(kGuard.isOrigin("http://127.0.0.1:8765", "127.0.0.1:8765"));
  EXPECT_TRUE(kGuard.isOrigin("http://[::1]:8765", "[::1]:8765"));
  EXPECT_TRUE(kGuard.isOrigin("https://app.foxglove.dev", "127.0.0.1:8765"));
}

TEST(Guard, OtherPagesMayNotAsk) {
  for (const char* origin :
       {"null", "http://evil.example", "http://127.0.0.1:8766", "http://127.0.0.1",
        "http://127.0.0.1:87650", "https://127.0.0.1:8765", "http://localhost:8765", "file://",
        "127.0.0.1:8765", "http://127.0.0.1:8765.evil.example", "https://app.foxglove.dev.evil.org",
        "http://app.foxglove.dev", "http://127.0.0.1:8765/", "HTTP://127.0.0.1:8765"})
    EXPECT_FALSE(kGuard.isOrigin(origin, "127.0.0.1:8765")) << origin;
}

}  // namespace
}  // namespace kelpie::web
