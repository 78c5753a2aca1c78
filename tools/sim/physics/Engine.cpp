// SPDX-License-Identifier: Apache-2.0
#include "tools/sim/physics/Engine.h"

#include <array>
#include <cstring>
#include <stdexcept>

namespace kelpie::sim {
namespace {

// MuJoCo's own would wait for a key and leave the program.
void throwError(const char* message) { throw std::runtime_error(message); }
// Warnings are counted in mjData, where step() reads them; MuJoCo's own writes a file.
void ignoreWarning(const char*) {}

void takeOver() {
  mju_user_error = throwError;
  mju_user_warning = ignoreWarning;
}

// A virtual file system is 2 MB: never on the stack.
struct Files {
  Files() : vfs(std::make_unique<mjVFS>()) { mj_defaultVFS(vfs.get()); }
  ~Files() { mj_deleteVFS(vfs.get()); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;
  std::unique_ptr<mjVFS> vfs;
};

constexpr const char* kFile = "world.xml";

Status addFile(const std::string& xml, mjVFS& vfs) {
  if (mj_makeEmptyFileVFS(&vfs, kFile, static_cast<int>(xml.size())) != 0)
    return Error{"the physical world's description does not fit into memory"};
  const int at = mj_findFileVFS(&vfs, kFile);
  std::memcpy(vfs.filedata[at], xml.data(), xml.size());
  return Done{};
}

const char* nameOf(int warning) {
  switch (warning) {
    case mjWARN_INERTIA: return "a mass matrix is near singular";
    case mjWARN_CONTACTFULL: return "more contacts than the buffer holds";
    case mjWARN_CNSTRFULL: return "more constraints than the buffer holds";
    case mjWARN_BADQPOS: return "a position is not finite or huge";
    case mjWARN_BADQVEL: return "a velocity is not finite or huge";
    case mjWARN_BADQACC: return "an acceleration is not finite or huge";
    case mjWARN_BADCTRL: return "a command is not finite";
    default: return nullptr;
  }
}

}  // namespace

Expected<Engine> Engine::load(const std::string& xml) {
  takeOver();
  try {
    const Files files;
    const Status added = addFile(xml, *files.vfs);
    if (!added) return Error{added.error()};
    std::array<char, 1000> error{};
    Engine engine;
    engine.model_.reset(mj_loadXML(kFile, files.vfs.get(), error.data(), error.size()));
    if (!engine.model_) return Error{std::string("the physical world: ") + error.data()};
    engine.data_.reset(mj_makeData(engine.model_.get()));
    if (!engine.data_) return Error{"the physical world does not fit into memory"};
    return engine;
  } catch (const std::runtime_error& e) {
    return Error{std::string("the physical world: ") + e.what()};
  }
}

Engine::Engine(const Engine& other)
    : model_(mj_copyModel(nullptr, other.model_.get())),
      data_(mj_copyData(nullptr, other.model_.get(), other.data_.get())) {}

int Engine::idOf(mjtObj kind, const std::string& name) const {
  return mj_name2id(model_.get(), kind, name.c_str());
}

// Of a bad number MuJoCo says which degree of freedom it is of, and that belongs to a body.
std::string Engine::warning() const {
  for (int w = 0; w < mjNWARNING; ++w) {
    const mjWarningStat& stat = data_->warning[w];
    if (stat.number == 0 || nameOf(w) == nullptr) continue;
    std::string line = nameOf(w);
    const bool ofMotion = w == mjWARN_BADQVEL || w == mjWARN_BADQACC;
    if (ofMotion && stat.lastinfo >= 0 && stat.lastinfo < model_->nv) {
      const int body = model_->dof_bodyid[stat.lastinfo];
      line += std::string(" of ") + mj_id2name(model_.get(), mjOBJ_BODY, body);
    }
    return line;
  }
  return {};
}

Status Engine::step(double seconds) {
  try {
    model_->opt.timestep = seconds;
    mj_step(model_.get(), data_.get());
  } catch (const std::runtime_error& e) {
    return Error{e.what()};
  }
  const std::string wrong = warning();
  if (!wrong.empty()) return Error{wrong};
  return Done{};
}

Status Engine::settle() {
  try {
    mj_forward(model_.get(), data_.get());
  } catch (const std::runtime_error& e) {
    return Error{e.what()};
  }
  return Done{};
}

}  // namespace kelpie::sim
