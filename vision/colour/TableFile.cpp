// SPDX-License-Identifier: Apache-2.0
#include "vision/colour/TableFile.h"

#include <cstring>
#include <fstream>
#include <iterator>

namespace kelpie::vision {
namespace {

constexpr char kMagic[] = "KELPIETB";
constexpr std::size_t kMagicLength = 8;
constexpr std::size_t kHeader = kMagicLength + 4 * 4;
constexpr std::size_t kChecksum = 4;
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kKindAt = kMagicLength + 4;
constexpr std::size_t kTextLengthAt = kMagicLength + 8;
constexpr std::size_t kDataLengthAt = kMagicLength + 12;
// Numbers are little-endian words of four bytes.
constexpr int kWordBits = 32;
constexpr int kByteBits = 8;
constexpr std::uint32_t kByteMask = 0xFFU;

// FNV-1a: catches a damaged stick, not an attacker.
std::uint32_t checksum(const std::uint8_t* bytes, std::size_t count) {
  constexpr std::uint32_t kOffsetBasis = 2166136261U;
  constexpr std::uint32_t kPrime = 16777619U;
  std::uint32_t hash = kOffsetBasis;
  for (std::size_t i = 0; i < count; ++i) hash = (hash ^ bytes[i]) * kPrime;
  return hash;
}

void append(Bytes& out, std::uint32_t value) {
  for (int shift = 0; shift < kWordBits; shift += kByteBits) {
    out.push_back(static_cast<std::uint8_t>((value >> shift) & kByteMask));
  }
}

std::uint32_t numberAt(const Bytes& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= static_cast<std::uint32_t>(bytes[at + i]) << (kByteBits * i);
  return value;
}

Error wrong(const std::string& path, const std::string& what) { return Error{path + ": " + what}; }

}  // namespace

Expected<Bytes> readBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return wrong(path, "cannot be opened");
  file.peek();  // fails on a folder, where the iterators below would throw
  if (file.bad()) return wrong(path, "cannot be read");
  Bytes bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (file.bad()) return wrong(path, "cannot be read");
  return bytes;
}

bool looksLikeTableFile(const Bytes& bytes) {
  return bytes.size() >= kMagicLength && std::memcmp(bytes.data(), kMagic, kMagicLength) == 0;
}

Expected<TableFile> parseTableFile(const std::string& path, const Bytes& bytes, TableKind kind,
                                   std::size_t dataSize) {
  if (!looksLikeTableFile(bytes) || bytes.size() < kHeader + kChecksum) {
    return wrong(path, std::to_string(bytes.size()) + " bytes, not a Kelpie table");
  }
  const std::uint32_t version = numberAt(bytes, kMagicLength);
  if (version != kVersion)
    return wrong(path, "table version " + std::to_string(version) + ", expected 1");
  if (numberAt(bytes, kKindAt) != static_cast<std::uint32_t>(kind)) {
    return wrong(path, "a Kelpie table of another kind");
  }
  const std::size_t textSize = numberAt(bytes, kTextLengthAt);
  const std::size_t size = numberAt(bytes, kDataLengthAt);
  if (size != dataSize || bytes.size() - kHeader - kChecksum != std::uint64_t{textSize} + size) {
    return wrong(path, std::to_string(bytes.size()) + " bytes, cut off or of another layout");
  }
  const std::size_t end = bytes.size() - kChecksum;
  if (checksum(bytes.data(), end) != numberAt(bytes, end)) return wrong(path, "checksum differs");
  TableFile file;
  file.kind = kind;
  const auto text = bytes.begin() + static_cast<std::ptrdiff_t>(kHeader);
  const auto data = text + static_cast<std::ptrdiff_t>(textSize);
  file.provenance.assign(text, data);
  file.data.assign(data, data + static_cast<std::ptrdiff_t>(size));
  return file;
}

Status writeTableFile(const std::string& path, const TableFile& file) {
  Bytes bytes(kMagic, kMagic + kMagicLength);
  append(bytes, kVersion);
  append(bytes, static_cast<std::uint32_t>(file.kind));
  append(bytes, static_cast<std::uint32_t>(file.provenance.size()));
  append(bytes, static_cast<std::uint32_t>(file.data.size()));
  bytes.insert(bytes.end(), file.provenance.begin(), file.provenance.end());
  bytes.insert(bytes.end(), file.data.begin(), file.data.end());
  append(bytes, checksum(bytes.data(), bytes.size()));
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
  out.flush();
  if (!out) return wrong(path, "cannot be written");
  return Done{};
}

}  // namespace kelpie::vision
