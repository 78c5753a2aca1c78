// SPDX-License-Identifier: Apache-2.0
#include "tests/stick/Sticks.h"
#include "tools/stick/WlanFile.h"

namespace kelpie::stick {
namespace {

constexpr const char* kGood =
    "# of the team\nESSID = fourlegged\nWEPENABLE=1\r\nWEPKEY=0x0123456789\n\nAPMODE=1\n"
    "ETHER_IP=10.0.1.3\nETHER_NETMASK=255.255.255.0\nUSE_DHCP=0\n";

Expected<WlanSettings> settingsOf(const std::string& text) {
  return wlanSettings(text, "keys.txt");
}

std::string complaint(const std::string& text) { return settingsOf(text).error(); }

TEST(WlanFile, KeepsKeysAndLeavesCommentsOut) {
  const auto settings = settingsOf(kGood);
  ASSERT_TRUE(settings) << settings.error();
  EXPECT_EQ(settings->text,
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
                           "APMODE=hush", "CHANNEL=12hush", "hush", "hush=HUSH", "WEPKEY hush",
                           "1HUSH=hush", "WEP KEY=hush", "SSDP_ENABLE=\"hush"}) {
    const std::string reported = complaint(std::string("ESSID=a\n") + line + "\n");
    EXPECT_NE(reported.find("keys.txt:2: "), std::string::npos) << reported;
    EXPECT_EQ(reported.find("hush"), std::string::npos) << reported;
  }
}

TEST(WlanFile, RefusesWhatNoRobotCanUse) {
  for (const auto* line :
       {"WEPENABLE=01", "USE_DHCP=00", "APMODE=01", "CHANNEL=012", "ETHER_IP=0.0.0.0",
        "ETHER_IP=255.255.255.255", "ETHER_IP=010.0.1.3", "ETHER_NETMASK=255.0.255.0",
        "ETHER_NETMASK=0.0.0.0", "ESSID=four # legged", "ESSID=four\x1blegged", "ESSID=\"four\"",
        "HOSTNAME=two words", "DNS_DEFDNAME=a;b"}) {
    const std::string reported = complaint(std::string("# first\n") + line + "\n");
    EXPECT_NE(reported.find("keys.txt:2: "), std::string::npos) << line << ": " << reported;
  }
  EXPECT_NE(complaint(std::string(kGood) + "HOSTNAME=" + std::string(64, 'a')).find("HOSTNAME"),
            std::string::npos);
  EXPECT_NE(complaint(std::string(kGood) + std::string(33, 'K') + "=1").find("not KEY=VALUE"),
            std::string::npos);
}

TEST(WlanFile, TakesEveryNetmask) {
  for (const auto* mask : {"255.255.255.255", "255.255.254.0", "128.0.0.0"}) {
    const auto settings =
        settingsOf(std::string("ESSID=a\nETHER_IP=10.0.1.3\nETHER_NETMASK=") + mask);
    EXPECT_TRUE(settings) << settings.error();
  }
}

// A channel is legal with every mode: a team of 2005 had it beside APMODE=1 in all of its files.
TEST(WlanFile, TakesEveryKindOfNetwork) {
  const std::string fixed = "ESSID=a\nETHER_IP=10.0.1.3\n";
  const std::string kinds[] = {fixed + "APMODE=0\nCHANNEL=11\n", fixed + "APMODE=1\nCHANNEL=3\n",
                               fixed + "APMODE=2\n", fixed + "CHANNEL=1\n",
                               "ESSID=a\nUSE_DHCP=1\nAPMODE=1\n"};
  for (const auto& kind : kinds) {
    const auto settings = settingsOf(kind);
    ASSERT_TRUE(settings) << kind << settings.error();
    EXPECT_EQ(settings->text, kind);
    EXPECT_EQ(unknownKeysLine(*settings, "keys.txt"), "");
  }
}

TEST(WlanFile, KeepsAndTellsKeysThatItDoesNotKnow) {
  const std::string text = "ESSID=a\nUSE_DHCP=1\nSSDP_ENABLE=1\nDNS_SERVER_2=hush # not\nTELNET=\n";
  EXPECT_NE(complaint(text).find("keys.txt:4: DNS_SERVER_2"), std::string::npos);
  const std::string plain = "ESSID=a\nUSE_DHCP=1\nSSDP_ENABLE=1\nDNS_SERVER_2=hush\nTELNET=\n";
  const auto settings = settingsOf(plain);
  ASSERT_TRUE(settings) << settings.error();
  EXPECT_EQ(settings->text, plain);
  EXPECT_EQ(unknownKeysLine(*settings, "keys.txt"),
            "keys.txt: not known here and kept as they are: SSDP_ENABLE, DNS_SERVER_2, TELNET");
}

TEST(WlanFile, LeavesKeysOfNothingOut) {
  const std::string fixed = "ESSID=a\nETHER_IP=10.0.1.3\n";
  const auto settings = settingsOf(fixed + "WEPENABLE=0\nWEPKEY=\nHOSTNAME=\nIP_GATEWAY= \n");
  ASSERT_TRUE(settings) << settings.error();
  EXPECT_EQ(settings->text, fixed + "WEPENABLE=0\n");
  EXPECT_EQ(settingsOf("ESSID=a\nUSE_DHCP=1\nETHER_IP=\nETHER_NETMASK=\nDNS_SERVER_1=\n")->text,
            "ESSID=a\nUSE_DHCP=1\n");
  EXPECT_NE(complaint("ESSID=a\nETHER_IP=\n").find("no ETHER_IP"), std::string::npos);
  EXPECT_NE(complaint(fixed + "WEPENABLE=1\nWEPKEY=\n").find("no WEPKEY"), std::string::npos);
  EXPECT_NE(complaint(fixed + "HOSTNAME=\nHOSTNAME=dog\n").find("twice"), std::string::npos);
  for (const auto* line : {"ESSID=", "WEPENABLE=", "APMODE=", "USE_DHCP="})
    EXPECT_NE(complaint(std::string("# first\n") + line + "\n").find("keys.txt:2: "),
              std::string::npos);
}

TEST(WlanFile, LeavesTheByteOrderMarkOfAnEditorOut) {
  EXPECT_EQ(settingsOf(std::string("\xEF\xBB\xBF") + kGood)->text, settingsOf(kGood)->text);
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
