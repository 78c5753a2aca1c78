// SPDX-License-Identifier: Apache-2.0
// A radio's settings of any text (WLANCONF.TXT). What is taken is taken again as it was made, and
// no refusal tells a value.
#include "tests/fuzz/Input.h"
#include "tools/stick/WlanFile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kelpie;
  const std::string text = fuzz::textOf(fuzz::Bytes(data, data + size));
  const auto settings = stick::wlanSettings(text, "WLANCONF.TXT");
  if (!settings) {
    fuzz::requireLine(settings.error(), "WLANCONF.TXT");
    return 0;
  }
  static_cast<void>(stick::unknownKeysLine(*settings, "WLANCONF.TXT"));
  const auto again = stick::wlanSettings(settings->text, "WLANCONF.TXT");
  fuzz::require(bool(again), "what was made is taken: " + again.error() + "\n" + settings->text);
  fuzz::require(again->text == settings->text, "and made alike");
  return 0;
}
