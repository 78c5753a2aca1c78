// SPDX-License-Identifier: Apache-2.0
#include "tools/cli/options/ServeOptions.h"

namespace kelpie::cli {

void addServeOptions(CommandLine& command, web::ServerParams& params) {
  command
      .option("--port", params.port, "TCP port of the studio and of viewers; 0: any that is free")
      .showDefault();
  command
      .option("--listen", params.address,
              "Address to serve at; another than this machine's own (127.0.0.1) lets everybody in "
              "the network watch")
      .check(notEmpty())
      .showDefault();
  command.option("--origin", params.origins,
                 "A web page that may watch beside the studio's own, as https://app.foxglove.dev");
}

}  // namespace kelpie::cli
