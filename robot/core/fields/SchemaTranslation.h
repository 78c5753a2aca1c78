// SPDX-License-Identifier: Apache-2.0
// Reads messages that were recorded with another version of a struct's field list: both versions
// are known as ROS 1 message text (Schema.h), the recorded one from the log itself. Members are
// found by name, or by the name that they had before; numbers of another width are converted; a
// member that the recorded list lacks gets its default. Fails where the recorded text is not ours
// to read, or the bytes do not fit it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "robot/core/Expected.h"

namespace kelpie {

// What one line of message text says: `type name`, `type[8] name`, `type[] name`. A `string` is a
// sequence of bytes.
struct SchemaMember {
  std::string name;
  std::string type;       // "float64", "kelpie/Pose2"
  bool sequence = false;  // any length, a uint32 before the elements
  std::size_t count = 1;  // elements of an array; 0 with `sequence`
  std::size_t width = 0;  // bytes of a number; 0: a struct
  double min = 0.0;       // the number nearest to 0 that its range allows
  bool isArray() const { return sequence || count != 1; }
};

using SchemaStruct = std::vector<SchemaMember>;

struct SchemaTypes {
  std::string root;
  std::map<std::string, SchemaStruct> structs;

  static Expected<SchemaTypes> parse(const std::string& root, const std::string& text);
};

class SchemaTranslation {
 public:
  // `name`: the message type; `theirs` and `ours`: its text as recorded and as it is now.
  static Expected<SchemaTranslation> make(const std::string& name, const std::string& theirs,
                                          const std::string& ours);

  // Bytes of the recorded list into bytes of ours; `defaults`: a default value in our encoding.
  // False when the recorded bytes do not fit their own text.
  bool translate(const std::uint8_t* data, std::size_t size,
                 const std::vector<std::uint8_t>& defaults, std::vector<std::uint8_t>& out) const;

  // Paths of our members that the recorded list lacks ("world.ball.stoppingPoint"), and of recorded
  // ones that we no longer have.
  const std::vector<std::string>& defaulted() const { return defaulted_; }
  const std::vector<std::string>& leftOut() const { return leftOut_; }

 private:
  SchemaTranslation(SchemaTypes theirs, SchemaTypes ours);
  void compare(const std::string& path, const std::string& theirType, const std::string& ourType);

  SchemaTypes theirs_;
  SchemaTypes ours_;
  std::vector<std::string> defaulted_;
  std::vector<std::string> leftOut_;
};

}  // namespace kelpie
