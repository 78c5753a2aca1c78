// SPDX-License-Identifier: Apache-2.0
#include "tools/viewer/Schemas.h"

#include <google/protobuf/descriptor.pb.h>

#include <set>

namespace kelpie::viewer {
namespace {

using google::protobuf::FileDescriptor;

// Whatever a file imports stands before it.
void add(const FileDescriptor& file, std::set<std::string>& known,
         google::protobuf::FileDescriptorSet& to) {
  if (!known.insert(file.name()).second) return;
  for (int i = 0; i < file.dependency_count(); ++i) add(*file.dependency(i), known, to);
  file.CopyTo(to.add_file());
}

}  // namespace

ReadyType readyTypeOf(const google::protobuf::Descriptor& type) {
  google::protobuf::FileDescriptorSet files;
  std::set<std::string> known;
  add(*type.file(), known, files);
  return {type.full_name(), "protobuf", files.SerializeAsString(), "protobuf"};
}

}  // namespace kelpie::viewer
