// SPDX-License-Identifier: Apache-2.0
// A message with a recorded field list of any text, read as today's: two bytes of the text's
// length, the text, then the message.
#include "robot/core/fields/Encoding.h"
#include "robot/core/fields/SchemaTranslation.h"
#include "robot/core/types/FrameOutput.h"
#include "tests/fuzz/Input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kelpie;
  fuzz::Input input(data, size);
  const std::uint32_t length = input.number(2);
  const std::string theirs = fuzz::textOf(input.take(length));
  const fuzz::Bytes message = input.rest();
  const auto translation =
      SchemaTranslation::make(schemaName<Command>(), theirs, schemaText<Command>());
  if (!translation) return 0;
  fuzz::Bytes defaults, out;
  encode(Command{}, defaults);
  Command command;
  if (translation->translate(message.data(), message.size(), defaults, out))
    static_cast<void>(decode(out.data(), out.size(), command));
  for (const auto& names : {translation->defaulted(), translation->leftOut()})
    for (const std::string& name : names) fuzz::require(!name.empty(), "what differs has a name");
  return 0;
}
