// SPDX-License-Identifier: Apache-2.0
#include "tools/broadcast/Stage.h"

#include <GL/osmesa.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "robot/body/Legs.h"
#include "tools/sim/physics/Engine.h"

namespace kelpie::broadcast {
namespace {

constexpr double kCm = 0.01;    // m
constexpr double kAway = -9.0;  // m: below the floor
constexpr int kGeoms = 1200;    // more than the stage has
constexpr double kPaw = 0.013;  // m, radius

cv::Size times(cv::Size size, double factor) {
  return {static_cast<int>(std::lround(factor * size.width)),
          static_cast<int>(std::lround(factor * size.height))};
}

struct FreeContext {
  void operator()(OSMesaContext context) const { OSMesaDestroyContext(context); }
};
using Context = std::unique_ptr<std::remove_pointer_t<OSMesaContext>, FreeContext>;

// Turns about the vertical, then about the axis to the right, then about the one ahead.
void setTurn(Angle yaw, Angle pitch, Angle roll, mjtNum* q) {
  const auto about = [](Angle angle, double x, double y, double z, mjtNum* out) {
    const mjtNum axis[3] = {x, y, z};
    mju_axisAngle2Quat(out, axis, angle.rad());
  };
  mjtNum a[4], b[4], c[4], ab[4];
  about(yaw, 0, 0, 1, a);
  about(pitch, 1, 0, 0, b);
  about(roll, 0, 1, 0, c);
  mju_mulQuat(ab, a, b);
  mju_mulQuat(q, ab, c);
}

}  // namespace

struct Stage::Studio {
  // MuJoCo's context goes before the one of OSMesa that it lives in.
  struct Renderer {
    mjvScene scene{};
    mjrContext context{};
    mjvOption option{};
    Renderer() {
      mjv_defaultScene(&scene);
      mjr_defaultContext(&context);
      mjv_defaultOption(&option);
    }
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;
    ~Renderer() {
      mjr_freeContext(&context);
      mjv_freeScene(&scene);
    }
  };

  cv::Size size;
  std::vector<std::uint8_t> screen;  // of OSMesa; the pictures are drawn beside it
  Context mesa;
  std::unique_ptr<sim::Engine> engine;
  std::unique_ptr<Renderer> renderer;
  std::map<Player, int> slots;  // qpos of each robot's free joint
  int ball = 0;                 // and of the ball's
  cv::Mat pixels;               // red, green, blue from the bottom up

  int qposOf(const std::string& joint) const {
    return engine->model().jnt_qposadr[engine->joint(joint)];
  }
  Status open(const body::FieldDescription& field, const std::set<Player>& players);
  Status openMesa();
  Status openRenderer();
  void place(const Actor& actor);
  void addShade(Point2<Field> middle, Angle heading, double wide, double length);
  void addShades();

  Tableau shown;
};

Status Stage::Studio::openMesa() {
  mesa.reset(OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, nullptr));
  screen.resize(64 * 64 * 4);
  if (!mesa || OSMesaMakeCurrent(mesa.get(), screen.data(), GL_UNSIGNED_BYTE, 64, 64) == 0)
    return Error{"no OSMesa to draw with (Debian: libosmesa6)"};
  return Done{};
}

Status Stage::Studio::openRenderer() {
  renderer = std::make_unique<Renderer>();
  mjv_makeScene(&engine->model(), &renderer->scene, kGeoms);
  mjr_makeContext(&engine->model(), &renderer->context, mjFONTSCALE_100);
  mjr_setBuffer(mjFB_OFFSCREEN, &renderer->context);
  if (renderer->context.currentBuffer != mjFB_OFFSCREEN)
    return Error{"OSMesa cannot draw off screen"};
  renderer->scene.flags[mjRND_REFLECTION] = 0;
  return Done{};
}

Status Stage::Studio::open(const body::FieldDescription& field, const std::set<Player>& players) {
  const Status opened = openMesa();
  if (!opened) return opened;
  auto loaded = sim::Engine::load(stageXml(field, players, pixels.cols, pixels.rows));
  if (!loaded) return Error{loaded.error()};
  engine = std::make_unique<sim::Engine>(std::move(*loaded));
  for (const auto& [team, player] : players)
    slots[{team, player}] = qposOf(slotName(team, player) + "_free");
  ball = qposOf("ball");
  return openRenderer();
}

// The joints stand in the model behind the free joint, the head's after the legs'.
void Stage::Studio::place(const Actor& actor) {
  const std::string name = slotName(actor.team, actor.player);
  mjtNum* const q = engine->data().qpos;
  mjtNum* const free = q + qposOf(name + "_free");
  const Point3<Robot> origin = body::robotFromTorso(actor.stance, {0.0, 0.0, 0.0});
  const Point2<Field> at = fieldFromRobot(actor.pose, {origin.x, origin.y});
  free[0] = kCm * at.x;
  free[1] = kCm * at.y;
  free[2] = kCm * origin.z;
  setTurn(actor.pose.heading - Angle::deg(90.0), Angle::rad(-actor.stance.bodyTilt.rad()),
          actor.stance.bodyRoll, free + 3);
  for (std::size_t j = 0; j < kHinges; ++j)
    q[qposOf(name + "_" + std::to_string(j))] = actor.joints.angle[j].rad();
}

// A flat dark ellipse on the carpet: the renderer's own shadows take three times as long.
void Stage::Studio::addShade(Point2<Field> middle, Angle heading, double wide, double length) {
  mjvScene& scene = renderer->scene;
  if (scene.ngeom >= scene.maxgeom) return;
  const mjtNum half[3] = {wide, length, 0.0006};
  const mjtNum place[3] = {kCm * middle.x, kCm * middle.y, 0.0016};
  mjtNum turn[4], matrix[9];
  setTurn(heading - Angle::deg(90.0), Angle(), Angle(), turn);
  mju_quat2Mat(matrix, turn);
  const float black[4] = {0.0F, 0.03F, 0.0F, 0.24F};
  mjvGeom* const shade = scene.geoms + scene.ngeom++;
  mjv_initGeom(shade, mjGEOM_ELLIPSOID, half, place, matrix, black);
  shade->category = mjCAT_DECOR;
  shade->transparent = 1;
}

// Of a robot a broad one under the body and a small dark one within.
void Stage::Studio::addShades() {
  for (const Actor& actor : shown.actors) {
    const Point2<Field> body = fieldFromRobot(actor.pose, Point2<Robot>{1.0, -6.0});
    addShade(body, actor.pose.heading, 0.088, 0.150);
    addShade(body, actor.pose.heading, 0.058, 0.115);
    const Point2<Field> head = fieldFromRobot(actor.pose, Point2<Robot>{1.0, 6.0});
    addShade(head, actor.pose.heading, 0.045, 0.055);
  }
  if (!shown.ballThere) return;
  const double radius = kCm * body::kBallRadius;
  addShade(shown.ball + Point2<Field>{-1.0, 0.6}, Angle(), radius, radius);
}

Expected<Stage> Stage::build(const body::FieldDescription& field, const std::set<Player>& players,
                             cv::Size size, double sharpness) {
  auto studio = std::make_unique<Studio>();
  studio->size = size;
  studio->pixels = cv::Mat(times(size, sharpness), CV_8UC3);
  try {
    const Status opened = studio->open(field, players);
    if (!opened) return Error{opened.error()};
  } catch (const std::runtime_error& error) {
    return Error{std::string("the stage cannot be drawn: ") + error.what()};
  }
  return Stage(std::move(studio));
}

Stage::Stage(std::unique_ptr<Studio> studio) : studio_(std::move(studio)) {}
Stage::Stage(Stage&&) noexcept = default;
Stage& Stage::operator=(Stage&&) noexcept = default;
Stage::~Stage() = default;

cv::Size Stage::size() const { return studio_->size; }

void Stage::put(const Tableau& tableau) {
  studio_->shown = tableau;
  mjData& data = studio_->engine->data();
  for (const auto& slot : studio_->slots) data.qpos[slot.second + 2] = kAway;
  for (const Actor& actor : tableau.actors)
    if (studio_->slots.count({actor.team, actor.player}) > 0) studio_->place(actor);
  mjtNum* const ball = data.qpos + studio_->ball;
  ball[0] = kCm * tableau.ball.x;
  ball[1] = kCm * tableau.ball.y;
  ball[2] = tableau.ballThere ? kCm * tableau.ballHeight : kAway;
  mj_kinematics(&studio_->engine->model(), &data);
  mj_comPos(&studio_->engine->model(), &data);
  mj_camlight(&studio_->engine->model(), &data);
}

Expected<cv::Mat> Stage::shoot(const View& view) {
  Studio& studio = *studio_;
  const cv::Vec3d way = view.target - view.eye;
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  camera.type = mjCAMERA_FREE;
  camera.distance = cv::norm(way);
  camera.azimuth = std::atan2(way[1], way[0]) * 180.0 / mjPI;
  camera.elevation = std::asin(way[2] / camera.distance) * 180.0 / mjPI;
  for (int i = 0; i < 3; ++i) camera.lookat[i] = view.target[i];
  try {
    mjv_updateScene(&studio.engine->model(), &studio.engine->data(), &studio.renderer->option,
                    nullptr, &camera, mjCAT_ALL, &studio.renderer->scene);
    studio.addShades();
    const mjrRect whole{0, 0, studio.pixels.cols, studio.pixels.rows};
    mjr_render(whole, &studio.renderer->scene, &studio.renderer->context);
    mjr_readPixels(studio.pixels.data, nullptr, whole, &studio.renderer->context);
  } catch (const std::runtime_error& error) {
    return Error{std::string("the stage cannot be drawn: ") + error.what()};
  }
  cv::Mat picture;
  cv::resize(studio.pixels, picture, studio.size, 0, 0, cv::INTER_AREA);
  cv::flip(picture, picture, 0);
  cv::cvtColor(picture, picture, cv::COLOR_RGB2BGR);
  return picture;
}

}  // namespace kelpie::broadcast
