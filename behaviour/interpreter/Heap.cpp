// SPDX-License-Identifier: Apache-2.0
#include "behaviour/interpreter/Heap.h"

#include <Python.h>
#include <malloc.h>

#include <algorithm>
#include <limits>

namespace kelpie::behaviour {
namespace {

constexpr auto kReserve = std::ptrdiff_t{1} << 20;  // an arena
constexpr auto kMax = std::numeric_limits<std::ptrdiff_t>::max() - kReserve;

std::ptrdiff_t sizeOf(void* block) {
  return static_cast<std::ptrdiff_t>(malloc_usable_size(block));
}

}  // namespace

// What Python had before is called behind each hook. Blocks and arenas that were asked for before
// the hooks may be given back to them, hence a count with a sign.
struct Heap::Hooks {
  PyMemAllocatorEx blocks{};
  PyObjectArenaAllocator arenas{};
  bool set = false;
  std::ptrdiff_t used = 0;
  std::ptrdiff_t limit = kMax;
  bool refused = false;  // a small piece, since the limit was set

  // Where there is no arena, Python asks for single blocks: the limit is reached when one of those
  // is refused.
  bool refuses(std::size_t size) {
    const std::ptrdiff_t room = limit - used + (refused ? kReserve : 0);
    const bool refuse = room < 0 || size > static_cast<std::size_t>(room);
    refused = refused || (refuse && size < static_cast<std::size_t>(kReserve));
    return refuse;
  }
  void* kept(void* block) {
    used += block != nullptr ? sizeOf(block) : 0;
    return block;
  }

  static void* allocate(void* self, std::size_t size) {
    auto& hooks = *static_cast<Hooks*>(self);
    if (hooks.refuses(size)) return nullptr;
    return hooks.kept(hooks.blocks.malloc(hooks.blocks.ctx, size));
  }
  static void* allocateZeros(void* self, std::size_t count, std::size_t size) {
    auto& hooks = *static_cast<Hooks*>(self);
    if (hooks.refuses(count * size)) return nullptr;  // Python has looked for an overflow
    return hooks.kept(hooks.blocks.calloc(hooks.blocks.ctx, count, size));
  }
  static void* resize(void* self, void* block, std::size_t size) {
    auto& hooks = *static_cast<Hooks*>(self);
    const std::ptrdiff_t before = block != nullptr ? sizeOf(block) : 0;
    const auto had = static_cast<std::size_t>(before);
    if (size > had && hooks.refuses(size - had)) return nullptr;
    void* const other = hooks.blocks.realloc(hooks.blocks.ctx, block, size);
    if (other != nullptr) hooks.used -= before;
    return hooks.kept(other);
  }
  static void release(void* self, void* block) {
    auto& hooks = *static_cast<Hooks*>(self);
    hooks.used -= block != nullptr ? sizeOf(block) : 0;
    hooks.blocks.free(hooks.blocks.ctx, block);
  }
  static void* allocateArena(void* self, std::size_t size) {
    auto& hooks = *static_cast<Hooks*>(self);
    if (hooks.refuses(size)) return nullptr;
    void* const arena = hooks.arenas.alloc(hooks.arenas.ctx, size);
    hooks.used += arena != nullptr ? static_cast<std::ptrdiff_t>(size) : 0;
    return arena;
  }
  static void releaseArena(void* self, void* arena, std::size_t size) {
    auto& hooks = *static_cast<Hooks*>(self);
    hooks.used -= static_cast<std::ptrdiff_t>(size);
    hooks.arenas.free(hooks.arenas.ctx, arena, size);
  }
};

Heap::Heap() : hooks_(std::make_unique<Hooks>()) {}

Heap::~Heap() {
  if (!hooks_->set) return;
  PyMem_SetAllocator(PYMEM_DOMAIN_RAW, &hooks_->blocks);
  PyObject_SetArenaAllocator(&hooks_->arenas);
}

void Heap::count() {
  PyMem_GetAllocator(PYMEM_DOMAIN_RAW, &hooks_->blocks);
  PyObject_GetArenaAllocator(&hooks_->arenas);
  PyMemAllocatorEx blocks{hooks_.get(), Hooks::allocate, Hooks::allocateZeros, Hooks::resize,
                          Hooks::release};
  PyObjectArenaAllocator arenas{hooks_.get(), Hooks::allocateArena, Hooks::releaseArena};
  PyMem_SetAllocator(PYMEM_DOMAIN_RAW, &blocks);
  PyObject_SetArenaAllocator(&arenas);
  hooks_->set = true;
}

std::size_t Heap::used() const {
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(hooks_->used, 0));
}

void Heap::limit(std::size_t bytes) {
  hooks_->refused = false;
  hooks_->limit = static_cast<std::ptrdiff_t>(std::min(bytes, static_cast<std::size_t>(kMax)));
}

}  // namespace kelpie::behaviour
