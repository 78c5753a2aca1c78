// SPDX-License-Identifier: Apache-2.0
#include "tests/stick/Sticks.h"
#include "tools/stick/WlanFile.h"

namespace kelpie::stick {
namespace {

constexpr const char* kGood =
    "# of the team\nESSID = fourlegged\nWEPENABLE=1\r\nWEPKEY=0x0123456789\n\nAPMODE=1\n"
    "ETHER_IP=10.0.1.3\nETHER_NETMASK=255.255.255.0\nUSE_DHCP=0\n";

std::string complaint(const std::string& text) { return wlanText(text, "keys.txt").error(); }

TEST(WlanFile, KeepsKeysAndLeavesCommentsOut) {
  const auto text = wlanText(kGood, "keys.txt");
  ASSERT_TRUE(text) << text.error();
  EXPECT_EQ(*text,
            "ESSID=fourlegged\nWEPENABLE=1\nWEPKEY=0x0123456789\nAPMODE=1\nETHER_IP=10.0.1.3\n"
            "ETHER_NETMASK=255.255.255.0\nUSE_DHCP=0\n");
}

TEST(WlanFile, NamesTheKeyThatIsMissing) {
  EXPECT_NE(complaint("ETHER_IP=10.0.1.3\n").find("no ESSID"), std::string::npos);
  EXPECT_NE(complaint("ESSID=a\nUSE_DHCP=1\nWEPENABLE=1\n").find("no WEPKEY"), std::string::npos);
  EXPECT_NE(complaint("ESSID=a\n").find("no ETHER_IP"), std::string::npos);
  EXPECT_NE(complaint("").find("no ESSID"), std::string::npos);
}

TEST(WlanFile, NamesLineAndKeyOfAWrongValueButNeverTheValue) {
  for (const auto* line : {"WEPKEY=hush!hush!", "WEPKEY=0xhushhushhu", "ETHER_IP=10.0.hush",
                           "APMODE=hush", "CHANNEL=12hush", "hush", "HUSH=hush", "WEPKEY hush"}) {
    const std::string told = complaint(std::string("ESSID=a\n") + line + "\n");
    EXPECT_NE(told.find("keys.txt:2: "), std::string::npos) << told;
    EXPECT_EQ(told.find("hush"), std::string::npos) << told;
  }
}

TEST(WlanFile, RefusesWhatNoRobotCanUse) {
  for (const auto* line :
       {"WEPENABLE=01", "USE_DHCP=00", "APMODE=01", "CHANNEL=012", "ETHER_IP=0.0.0.0",
        "ETHER_IP=255.255.255.255", "ETHER_IP=010.0.1.3", "ETHER_NETMASK=255.0.255.0",
        "ETHER_NETMASK=0.0.0.0", "ESSID=four # legged", "ESSID=four\x1blegged", "ESSID=\"four\"",
        "HOSTNAME=two words", "DNS_DEFDNAME=a;b"}) {
    const std::string told = complaint(std::string("# first\n") + line + "\n");
    EXPECT_NE(told.find("keys.txt:2: "), std::string::npos) << line << ": " << told;
  }
  EXPECT_NE(complaint(std::string(kGood) + "HOSTNAME=" + std::string(64, 'a')).find("HOSTNAME"),
            std::string::npos);
  EXPECT_NE(complaint(std::string(kGood) + "CHANNEL=5\n").find("APMODE=0"), std::string::npos);
}

TEST(WlanFile, TakesAChannelAdHocAndEveryNetmask) {
  const std::string adHoc = "ESSID=a\nETHER_IP=10.0.1.3\nAPMODE=0\nCHANNEL=11\n";
  for (const auto* mask : {"255.255.255.255", "255.255.254.0", "128.0.0.0"}) {
    const auto text = wlanText(adHoc + "ETHER_NETMASK=" + mask, "keys.txt");
    EXPECT_TRUE(text) << text.error();
  }
}

TEST(WlanFile, LeavesTheByteOrderMarkOfAnEditorOut) {
  EXPECT_EQ(*wlanText(std::string("\xEF\xBB\xBF") + kGood, "keys.txt"),
            *wlanText(kGood, "keys.txt"));
}

TEST(WlanFile, RefusesAKeyThatIsThereTwice) {
  EXPECT_NE(complaint("ESSID=a\nESSID=b\n").find("keys.txt:2: ESSID is there twice"),
            std::string::npos);
}

TEST(WlanFile, RefusesAFileInTheSourceTreeAndOneThatIsMissing) {
  EXPECT_NE(readWlanFile(KELPIE_SOURCE_DIR "/keys.txt").error().find("source tree"),
            std::string::npos);
  EXPECT_NE(readWlanFile("/no/such/keys.txt").error().find("does not exist"), std::string::npos);
}

}  // namespace
}  // namespace kelpie::stick
