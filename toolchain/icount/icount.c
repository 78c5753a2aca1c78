/* SPDX-License-Identifier: Apache-2.0
 * A plugin for qemu-mipsel: counts instructions by class, memory accesses and modelled cache misses
 * between the program's markers (toolchain/target/StageMarkers.cpp) and writes a line per interval:
 *   from to instructions loads stores branches fp mul div mips32 l1i l1d l2 cycles
 * with the tags of its two markers; -1 is the program's start. The first line names the columns.
 * The last line, "pages", has the number of every page that the program read, wrote or ran: what it
 * keeps of a machine's memory at most, since a page that was given back is counted all the same.
 *   qemu-mipsel -plugin libicount.so,out=FILE PROGRAM
 * Model, measured on nothing: single issue, L1 I and D 16 KB, L2 256 KB, all 4-way with 32-byte
 * lines; 6 cycles for what L1 misses, 60 more for what L2 misses. Wrong where QEMU is not 7.2: the
 * interface changes with later versions. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cache.h"
#include "mips.h"
#include "plugin_api.h"

__attribute__((visibility("default"))) int qemu_plugin_version = 1;

enum { kGetPriority = 4096, kMagic = 0x41694230, kL1MissCycles = 6, kL2MissCycles = 60 };
enum { kPageShift = 12 };

struct Counts {
  uint64_t instructions, loads, stores, mips32, l1i, l1d, l2, cycles;
  uint64_t classes[kClasses];
};

/* What one run of a translated block adds, and the instruction lines it touches. */
struct Block {
  struct Counts adds;
  uint32_t firstLine, lines;
};

static struct Counts counts, before;
static struct Cache instructionCache = {.sets = 128}, dataCache = {.sets = 128},
                    secondCache = {.sets = 2048};
static uint8_t touched[1 << (32 - kPageShift)];
static FILE* out;
static int lastTag = -1;

static void missed(uint32_t line) {
  counts.cycles += kL1MissCycles;
  if (!cacheMisses(&secondCache, line)) return;
  ++counts.l2;
  counts.cycles += kL2MissCycles;
}

static void onBlock(unsigned int vcpu, void* data) {
  (void)vcpu;
  const struct Block* block = data;
  counts.instructions += block->adds.instructions;
  counts.mips32 += block->adds.mips32;
  counts.cycles += block->adds.cycles;
  for (int i = 0; i < kClasses; ++i) counts.classes[i] += block->adds.classes[i];
  for (uint32_t i = 0; i < block->lines; ++i) {
    if (!cacheMisses(&instructionCache, block->firstLine + i)) continue;
    ++counts.l1i;
    missed(block->firstLine + i);
  }
}

static void onMemory(unsigned int vcpu, qemu_plugin_meminfo_t info, uint64_t address, void* data) {
  (void)vcpu;
  (void)data;
  const bool store = qemu_plugin_mem_is_store(info);
  ++*(store ? &counts.stores : &counts.loads);
  touched[(uint32_t)address >> kPageShift] = 1;
  const uint32_t line = (uint32_t)address >> kLineShift;
  if (!cacheMisses(&dataCache, line)) return;
  ++counts.l1d;
  missed(line);
}

static void onTranslate(qemu_plugin_id_t id, struct qemu_plugin_tb* tb) {
  (void)id;
  struct Block* block = calloc(1, sizeof *block);
  if (block == NULL) abort();
  const size_t size = qemu_plugin_tb_n_insns(tb);
  for (size_t i = 0; i < size; ++i) {
    struct qemu_plugin_insn* insn = qemu_plugin_tb_get_insn(tb, i);
    uint32_t word = 0;
    memcpy(&word, qemu_plugin_insn_data(insn), sizeof word);
    const enum Class kind = mipsClass(word);
    ++block->adds.classes[kind];
    block->adds.cycles += kClassCycles[kind];
    block->adds.mips32 += isMips32(word) ? 1 : 0;
    const uint32_t address = (uint32_t)qemu_plugin_insn_vaddr(insn);
    touched[address >> kPageShift] = 1;
    const uint32_t line = address >> kLineShift;
    if (i == 0) block->firstLine = line;
    block->lines = line - block->firstLine + 1;
    qemu_plugin_register_vcpu_mem_cb(insn, onMemory, QEMU_PLUGIN_CB_NO_REGS, QEMU_PLUGIN_MEM_RW,
                                     NULL);
  }
  block->adds.instructions = size;
  qemu_plugin_register_vcpu_tb_exec_cb(tb, onBlock, QEMU_PLUGIN_CB_NO_REGS, block);
}

#define DELTA(name) ((unsigned long long)(counts.name - before.name))

static void printInterval(int tag) {
  const uint64_t* c = counts.classes;
  const uint64_t* b = before.classes;
  unsigned long long fp = 0;
  for (int i = kFp; i < kClasses; ++i) fp += c[i] - b[i];
  fprintf(out, "%d %d %llu %llu %llu %llu %llu %llu %llu %llu %llu %llu %llu %llu\n", lastTag, tag,
          DELTA(instructions), DELTA(loads), DELTA(stores), DELTA(classes[kBranch]), fp,
          DELTA(classes[kMul]), DELTA(classes[kDiv]), DELTA(mips32), DELTA(l1i), DELTA(l1d),
          DELTA(l2), DELTA(cycles));
  before = counts;
  lastTag = tag;
}

static void onSyscall(qemu_plugin_id_t id, unsigned int vcpu, int64_t number, uint64_t magic,
                      uint64_t tag, uint64_t a3, uint64_t a4, uint64_t a5, uint64_t a6, uint64_t a7,
                      uint64_t a8) {
  (void)id, (void)vcpu, (void)a3, (void)a4, (void)a5, (void)a6, (void)a7, (void)a8;
  if (number == kGetPriority && (uint32_t)magic == kMagic) printInterval((int)(tag & 0xffff));
}

static void printPages(void) {
  fprintf(out, "pages");
  for (uint32_t page = 0; page < sizeof touched; ++page)
    if (touched[page]) fprintf(out, " %u", page);
  fprintf(out, "\n");
}

static void onExit(qemu_plugin_id_t id, void* data) {
  (void)id, (void)data;
  printPages();
  if (fclose(out) != 0) perror("icount");
}

__attribute__((visibility("default"))) int qemu_plugin_install(qemu_plugin_id_t id,
                                                               const qemu_info_t* info, int argc,
                                                               char** argv) {
  (void)info;
  if (argc != 1 || strncmp(argv[0], "out=", 4) != 0) {
    fprintf(stderr, "icount: usage: -plugin libicount.so,out=FILE\n");
    return 1;
  }
  out = fopen(argv[0] + 4, "w");
  if (out == NULL) {
    perror(argv[0] + 4);
    return 1;
  }
  fprintf(out, "from to instructions loads stores branches fp mul div mips32 l1i l1d l2 cycles\n");
  qemu_plugin_register_vcpu_tb_trans_cb(id, onTranslate);
  qemu_plugin_register_vcpu_syscall_cb(id, onSyscall);
  qemu_plugin_register_atexit_cb(id, onExit, NULL);
  return 0;
}
