// SPDX-License-Identifier: Apache-2.0
// MuJoCo behind a door that never fails silently: loading, stepping, and every way in which a
// simulation goes wrong as one line. Without it MuJoCo prints, waits for a key, writes a file into
// the working directory, resets all robots when one number is not finite, and lets contacts vanish
// when a buffer is full.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>

#include "robot/core/Expected.h"

namespace kelpie::sim {

class Engine {
 public:
  // From XML text. The error is MuJoCo's own line.
  static Expected<Engine> load(const std::string& xml);

  // A copy goes on from the same instant, apart.
  Engine(const Engine& other);
  Engine(Engine&&) = default;
  Engine& operator=(const Engine&) = delete;
  Engine& operator=(Engine&&) = default;
  ~Engine() = default;

  mjModel& model() { return *model_; }
  const mjModel& model() const { return *model_; }
  mjData& data() { return *data_; }
  const mjData& data() const { return *data_; }

  // Ids by name; the name must be in the model.
  int body(const std::string& name) const { return idOf(mjOBJ_BODY, name); }
  int geom(const std::string& name) const { return idOf(mjOBJ_GEOM, name); }
  int joint(const std::string& name) const { return idOf(mjOBJ_JOINT, name); }
  int actuator(const std::string& name) const { return idOf(mjOBJ_ACTUATOR, name); }

  // One step of so many seconds, or what went wrong: from then on the state means nothing.
  Status step(double seconds);
  // After places were changed by hand.
  Status settle();

 private:
  Engine() = default;
  struct Free {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  int idOf(mjtObj kind, const std::string& name) const;
  std::string warning() const;

  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
};

}  // namespace kelpie::sim
