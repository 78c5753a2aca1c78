// SPDX-License-Identifier: Apache-2.0
// A robot's EMON.LOG and the program that died: two bytes of the log's length, the log, then the
// program. Every place that is found is code of the program.
#include "tests/fuzz/Input.h"
#include "tools/stick/EmonLog.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kelpie;
  fuzz::Input input(data, size);
  const std::uint32_t length = input.number(2);
  const std::string text = fuzz::textOf(input.take(length));
  const std::string program = fuzz::textOf(input.rest());
  static_cast<void>(stick::ElfObject::checkProgram(program, "program"));
  const auto log = stick::parseEmonLog(text, "EMON.LOG");
  const auto object = stick::ElfObject::parse(program, "program");
  if (!log) fuzz::requireLine(log.error(), "EMON.LOG");
  if (!object) fuzz::requireLine(object.error(), "program");
  if (log && log->cause) static_cast<void>(stick::causeText(*log->cause));
  if (!log || !object) return 0;
  const auto offset = stick::loadOffset(*log, *object, std::nullopt);
  const auto places = stick::crashPlaces(*log, *object, offset ? *offset : 0);
  if (!places) return 0;
  for (const stick::CrashPlace& place : *places)
    fuzz::require(object->isCode(place.address), place.where + " is code of the program");
  return 0;
}
