// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/ViewerFile.h"

#include "tools/viewer/Schemas.h"

namespace kelpie::viewer {

Expected<ViewerFile> ViewerFile::create(const std::string& path) {
  auto writer = LogWriter::open(path, defaultLogOptions(), "");
  if (!writer) return Error{writer.error()};
  return Expected<ViewerFile>(ViewerFile(std::move(*writer)));
}

void ViewerFile::take(const std::string& topic, TimeUs time,
                      const google::protobuf::Message& message) {
  const google::protobuf::Descriptor* const type = message.GetDescriptor();
  auto known = types_.find(type);
  if (known == types_.end()) known = types_.emplace(type, readyTypeOf(*type)).first;
  message.SerializeToString(&bytes_);
  writer_.write(topic, time, known->second, bytes_);
  ++messages_;
}

}  // namespace kelpie::viewer
