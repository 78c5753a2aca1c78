// SPDX-License-Identifier: Apache-2.0
// Where a robot's program died: the addresses of its EMON.LOG as functions and lines.
#include <fmt/core.h>

#include <charconv>
#include <memory>

#include "tools/cli/Commands.h"
#include "tools/cli/options/Usage.h"
#include "tools/stick/EmonLog.h"
#include "tools/stick/Programs.h"

namespace kelpie::cli {
namespace {

struct EmonOptions {
  std::string log;
  std::string object;
  std::string loadedAt;
};

Expected<std::optional<std::uint32_t>> address(const std::string& text) {
  if (text.empty()) return std::optional<std::uint32_t>();
  std::uint32_t value = 0;
  const std::size_t digits = text.rfind("0x", 0) == 0 ? 2 : 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + digits, end, value, 16);
  if (error != std::errc() || rest != end)
    return Error{"--loaded-at " + text + ": is not a hexadecimal address"};
  return std::optional<std::uint32_t>(value);
}

// An object is loaded at a whole page; by the gp of another build it seems not to be.
void tellOffset(std::uint32_t offset) {
  constexpr std::uint32_t kPage = 4096;
  fmt::print("loaded 0x{:08x} above its linked address{}\n", offset,
             offset % kPage == 0 ? "" : ", which is no page: is --object of ANOTHER BUILD?");
}

void tell(const stick::EmonLog& log, const std::vector<stick::CrashPlace>& places,
          const std::vector<std::string>& lines) {
  if (log.cause) fmt::print("exception {}\n", stick::causeText(*log.cause));
  fmt::print("died at 0x{:08x}", *log.counter);
  if (log.badAddress) fmt::print(", bad address 0x{:08x}", *log.badAddress);
  fmt::print("\n");
  for (std::size_t i = 0; i < places.size(); ++i)
    fmt::print("{:10} {}\n", places[i].where, lines[i]);
  fmt::print("What has an address of the stack may also be left from an earlier call.\n");
}

Status explain(const EmonOptions& options) {
  const auto loadedAt = address(options.loadedAt);
  if (!loadedAt) return Error{loadedAt.error()};
  const auto text = stick::readWhole(options.log);
  if (!text) return Error{text.error()};
  const auto log = stick::parseEmonLog(*text, options.log);
  if (!log) return Error{log.error()};
  auto bytes = stick::readWhole(options.object);
  if (!bytes) return Error{bytes.error()};
  const auto object = stick::ElfObject::parse(std::move(*bytes), options.object);
  if (!object) return Error{object.error()};
  const auto offset = stick::loadOffset(*log, *object, *loadedAt);
  if (!offset) return Error{options.log + ": " + offset.error()};
  const auto places = stick::crashPlaces(*log, *object, *offset);
  if (!places) return Error{options.log + ": " + places.error()};
  const auto lines = stick::linesOf(*places, options.object);
  if (!lines) return Error{lines.error()};
  tellOffset(*offset);
  tell(*log, *places, *lines);
  return Done{};
}

int run(const EmonOptions& options) {
  const Status explained = explain(options);
  return explained ? kExitDone : fail(explained.error(), kExitBadInput);
}

}  // namespace

void addEmon(CommandLine& app, int& code) {
  auto command =
      app.subcommand("emon", "Where a robot's program died: EMON.LOG as functions and lines");
  auto options = std::make_shared<EmonOptions>();
  command.option("FILE", options->log, "The stick's EMON.LOG").required();
  command
      .option("--object", options->object,
              "The agent.nosnap.elf that was made with the AGENT.BIN on that stick")
      .required();
  command.option("--loaded-at", options->loadedAt,
                 "How far from its linked address it was, hexadecimal (else by gp)");
  command.callback([options, &code] { code = run(*options); });
}

}  // namespace kelpie::cli
