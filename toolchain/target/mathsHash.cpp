// SPDX-License-Identifier: Apache-2.0
// maths-hash: one number from 100 000 random arguments of every function in robot/core/Maths.h. The
// PC's and the target's must be equal, or no replay can be.
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "robot/core/Maths.h"
#include "robot/core/Random.h"

namespace {

constexpr int kArguments = 100000;

class Hash {
 public:
  void add(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    for (int shift = 0; shift < 64; shift += 8) {
      hash_ = (hash_ ^ ((bits >> shift) & 0xff)) * 0x100000001b3ULL;  // FNV-1a
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

}  // namespace

int main() {
  namespace maths = kelpie::maths;
  kelpie::Random random(20060614);
  Hash hash;
  for (int i = 0; i < kArguments; ++i) {
    const double x = random.uniform(-30.0, 30.0);
    const double y = random.gaussian(0.0, 10.0);
    hash.add(maths::sin(x));
    hash.add(maths::cos(y));
    hash.add(maths::tan(x));
    hash.add(maths::atan(y));
    hash.add(maths::atan2(y, x));
    hash.add(maths::asin(x / 30.0));
    hash.add(maths::acos(x / 30.0));
    hash.add(maths::exp(x));
    hash.add(maths::log(x * x));
    hash.add(maths::hypot(x, y));
  }
  std::printf("%016llx\n", static_cast<unsigned long long>(hash.value()));
  return 0;
}
