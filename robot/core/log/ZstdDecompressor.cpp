// SPDX-License-Identifier: Apache-2.0
// For what reads logs of the host, the target program included: chunks compressed with zstd.
#include <zstd.h>

#include "robot/core/log/ChunkBuffer.h"
#include "robot/core/log/ChunkCodec.h"

namespace kelpie {
namespace {

// No more than 128 KB come out of a block, and a block takes 4 bytes at least.
constexpr std::size_t kMaxRatio = 32768;

// Known before memory is taken.
bool mayHold(const std::uint8_t* from, std::size_t size, std::size_t count) {
  const unsigned long long said = ZSTD_getFrameContentSize(from, size);
  const bool known = said != ZSTD_CONTENTSIZE_UNKNOWN && said != ZSTD_CONTENTSIZE_ERROR;
  return count / kMaxRatio <= size && (!known || said <= count);
}

Status statusOf(std::size_t result) {
  if (ZSTD_isError(result) == 0) return Done{};
  return Error{std::string("zstd: ") + ZSTD_getErrorName(result)};
}

class ZstdDecompressor : public ChunkDecompressor {
 public:
  ~ZstdDecompressor() override { ZSTD_freeDCtx(context_); }

  Status decompress(const std::uint8_t* from, std::size_t size, std::size_t count,
                    std::vector<std::uint8_t>& to) override {
    to.clear();
    if (context_ == nullptr) context_ = ZSTD_createDCtx();
    if (context_ == nullptr) return Error{"zstd: no memory"};
    if (!mayHold(from, size, count)) {
      return Error{"zstd: its " + std::to_string(size) + " bytes do not hold the " +
                   std::to_string(count) + " that it says"};
    }
    growTo(to, count);
    to.resize(count);
    const std::size_t got = ZSTD_decompressDCtx(context_, to.data(), count, from, size);
    const Status done = statusOf(got);
    if (done && got == count) return done;
    to.clear();
    if (!done) return done;
    return Error{"zstd: " + std::to_string(got) + " bytes instead of " + std::to_string(count)};
  }

 private:
  ZSTD_DCtx* context_ = nullptr;
};

}  // namespace

std::unique_ptr<ChunkDecompressor> makeDecompressor(std::string_view compression) {
  if (compression == "zstd") return std::make_unique<ZstdDecompressor>();
  return nullptr;
}

}  // namespace kelpie
