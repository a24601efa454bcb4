// creaking_lamp TREE.tt FILE.wav [SECONDS]: a lamp crouches and hops (Hahn and others 1995, figures 9 and 10). Bullet
// moves it with 300 steps per second. In each step the program sets the parameters of timbre trees and renders their
// sound.

#include <btBulletDynamicsCommon.h>
#include <sndfile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <exception>
#include <numbers>
#include <vector>

#include "idiophone/timbre/language/live_sound.hpp"
#include "idiophone/timbre/language/tree_builder.hpp"

namespace timbre = idiophone::timbre;
using timbre::node;

constexpr int rate = 44100, steps_per_second = 300, samples_per_step = rate / steps_per_second;

/// The squeak of a joint: a rough sawtooth that follows the angular velocity.
timbre::Tree squeak() {
  timbre::TreeBuilder tree("squeak");
  const timbre::Expression speed = tree.parameter("speed");  // rad/s, zero while it turns the other way
  const timbre::Expression pitch = tree.parameter("pitch");  // Hz, at rest
  const timbre::Expression rasp = tree.define("rasp", 1 + 0.03 * node("perlin", 90));
  const timbre::Expression sawtooth = node("sawtooth", rasp * (pitch + 80 * speed));
  return tree.finish(node("tanh", 0.2 * speed) * node("bandpass", sawtooth, 1800, 0.8));
}

/// A plucked string.
timbre::Tree pluck() {
  timbre::TreeBuilder tree("pluck");
  const timbre::Expression pitch = tree.parameter("pitch");  // Hz
  return tree.finish(node("combine", node("damp", node("*", pitch, node("vector", 1, 2, 3)), 0.001) *
                                         node("sine", node("*", pitch, node("vector", 1, 2, 3)))));
}

/// A joint that follows a wanted angle. It has two sounds, one for each direction.
class Joint {
 public:
  Joint(btRigidBody& below, float top, btRigidBody& above, float bottom, double pitch)
      : below_(below),
        above_(above),
        hinge_(below, above, {0, top, 0}, {0, -bottom, 0}, {0, 0, 1}, {0, 0, 1}),
        opening_(squeak(), {.live = {{"speed", 0}}, .constants = {{"pitch", pitch}}}),
        closing_(squeak(), {.live = {{"speed", 0}}, .constants = {{"pitch", 0.7 * pitch}}}) {
    hinge_.enableMotor(true);
    hinge_.setMaxMotorImpulse(0.05F);
  }

  btHingeConstraint& hinge() { return hinge_; }
  double angle() { return hinge_.getHingeAngle(); }  // rad

  void follow(double angle) { hinge_.setMotorTarget(static_cast<btScalar>(angle), 0.05F); }

  void set_sounds() {
    const double speed = above_.getAngularVelocity().z() - below_.getAngularVelocity().z();
    opening_.set("speed", std::max(0.0, speed));
    closing_.set("speed", std::max(0.0, -speed));
  }

  std::array<timbre::LiveSound*, 2> sounds() { return {&opening_, &closing_}; }

 private:
  btRigidBody &below_, &above_;
  btHingeConstraint hinge_;
  timbre::LiveSound opening_, closing_;
};

/// Floor, base, two arms and head; everything moves in one plane.
struct World {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broad_phase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld dynamics{&dispatcher, &broad_phase, &solver, &configuration};
  btBoxShape floor_shape{{5, 0.1F, 5}}, base_shape{{0.1F, 0.02F, 0.1F}}, arm{{0.01F, 0.12F, 0.01F}},
      shade{{0.05F, 0.04F, 0.05F}};
  std::deque<btRigidBody> bodies;
  btRigidBody &floor{add(floor_shape, -0.1F, 0)}, &base{add(base_shape, 0.02F, 1)};
  btRigidBody &lower{add(arm, 0.17F, 0.1)}, &upper{add(arm, 0.42F, 0.1)}, &head{add(shade, 0.59F, 0.1)};
  Joint ankle{base, 0.025F, lower, 0.125F, 520}, knee{lower, 0.125F, upper, 0.125F, 610},
      neck{upper, 0.125F, head, 0.045F, 700};
  std::deque<timbre::LiveSound> started;  // landings and notes
  timbre::Tree knock, string = pluck();
  unsigned steps = 0, landings = 0, notes = 0;
  double note = 0.0;  // Hz, that sounds now

  explicit World(const char* tree) : knock(timbre::read_tree_file(tree)) {
    dynamics.setGravity({0, -9.81F, 0});
    for (Joint* joint : {&ankle, &knee, &neck}) dynamics.addConstraint(&joint->hinge(), true);
    base.setAngularFactor(0);  // the lamp keeps its balance
  }

  btRigidBody& add(btCollisionShape& shape, float height, double mass) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0.0) shape.calculateLocalInertia(static_cast<btScalar>(mass), inertia);
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass), nullptr, &shape, inertia);
    info.m_startWorldTransform.setOrigin({0, height, 0});
    info.m_restitution = 0.2F;
    dynamics.addRigidBody(&bodies.emplace_back(info));
    bodies.back().setActivationState(DISABLE_DEACTIVATION);
    bodies.back().setLinearFactor({1, 1, 0});
    bodies.back().setAngularFactor({0, 0, 1});
    return bodies.back();
  }

  /// It crouches for 0.8 s, then stretches and hops; and so on.
  void move() {
    const double phase = std::fmod(static_cast<double>(steps) / steps_per_second, 1.5);
    const double crouch =
        phase < 0.8 ? 0.5 - 0.5 * std::cos(std::numbers::pi * phase / 0.8) : std::max(0.0, 1 - 8 * (phase - 0.8));
    ankle.follow(0.6 * crouch);
    knee.follow(-1.3 * crouch);
    neck.follow(1.0 * crouch);
    if (steps % (3 * steps_per_second / 2) == 9 * steps_per_second / 10) {
      for (btRigidBody& body : bodies) body.setLinearVelocity(body.getLinearVelocity() + btVector3(0.3F, 1.5F, 0));
    }
  }

  /// A landing of the base starts a sound, as strong as its impulse: the same base, but another noise each time.
  void start_landings() {
    double impulse = 0.0;  // N s
    for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
      const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(m);
      for (int p = 0; p < manifold.getNumContacts(); ++p) {
        const btManifoldPoint& point = manifold.getContactPoint(p);
        impulse += point.getLifeTime() <= 1 ? point.getAppliedImpulse() : 0.0;
      }
    }
    if (impulse > 0.1) {
      started.emplace_back(knock, timbre::LiveSoundOptions{.start = landings++, .constants = {{"impulse", impulse}}});
    }
  }

  /// Four times a second, the angle of the knee is a note of a blues scale. Equal notes are slurred.
  void start_note() {
    constexpr std::array scale{0, 3, 5, 6, 7, 10, 12, 15, 17, 18, 19, 22, 24};
    const double share = std::clamp(-knee.angle() / 1.3, 0.0, 1.0);
    const double pitch = 220.0 * std::exp2(scale[std::lround(share * (scale.size() - 1))] / 12.0);
    if (pitch != note) {
      note = pitch;
      ++notes;
      started.emplace_back(string, timbre::LiveSoundOptions{.constants = {{"pitch", pitch}}});
    }
  }

  void step() {
    move();
    dynamics.stepSimulation(1.0F / steps_per_second, 1, 1.0F / steps_per_second);
    for (Joint* joint : {&ankle, &knee, &neck}) joint->set_sounds();
    start_landings();
    if (steps % (steps_per_second / 4) == 0) start_note();
    ++steps;
  }

  void render(std::vector<double>& block) {
    std::vector<double> sound(block.size());
    std::ranges::fill(block, 0.0);
    const auto add_sound = [&](timbre::LiveSound& live, double gain) {
      live.render(sound);
      for (std::size_t i = 0; i < block.size(); ++i) block[i] += gain * sound[i];
    };
    for (Joint* joint : {&ankle, &knee, &neck}) {
      for (timbre::LiveSound* squeak : joint->sounds()) add_sound(*squeak, 0.15);
    }
    for (timbre::LiveSound& live : started) add_sound(live, 0.04);
    std::erase_if(started, [](const timbre::LiveSound& live) { return live.silent_for() > 0.1; });
  }
};

int main(int count, char** arguments) try {
  SF_INFO format{};
  format.samplerate = rate;
  format.channels = 1;
  format.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
  SNDFILE* file = count > 2 ? sf_open(arguments[2], SFM_WRITE, &format) : nullptr;
  if (file == nullptr) {
    std::fprintf(stderr, "usage: creaking_lamp TREE.tt FILE.wav [SECONDS]\n");
    return 1;
  }
  const double seconds = count > 3 ? std::atof(arguments[3]) : 4.5;
  World world(arguments[1]);
  std::vector<double> block(samples_per_step);
  for (int step = 0; step < seconds * steps_per_second; ++step) {
    world.step();
    world.render(block);
    sf_write_double(file, block.data(), samples_per_step);
  }
  sf_close(file);
  std::printf("%u landings, %u notes, %.2f m from the start\n", world.landings, world.notes,
              static_cast<double>(world.base.getWorldTransform().getOrigin().x()));
} catch (const std::exception& error) {
  std::fprintf(stderr, "creaking_lamp: %s\n", error.what());
  return 1;
}
