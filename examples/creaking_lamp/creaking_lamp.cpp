// creaking_lamp TREE.tt FILE.wav [SECONDS]: a lamp swings on its hinge and knocks blocks over. Bullet moves them with
// 300 steps per second. In each step the program sets the parameters of the timbre trees and renders a block of their
// sound.

#include <btBulletDynamicsCommon.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <exception>
#include <vector>

#include "idiophone/timbre/language/live_sound.hpp"
#include "idiophone/timbre/language/tree_builder.hpp"

namespace timbre = idiophone::timbre;

constexpr int rate = 44100, steps_per_second = 300, samples_per_step = rate / steps_per_second;
constexpr double least_impulse = 0.002;  // N s, of a contact that sounds

/// The squeak of a hinge: a rough sawtooth that follows the angular velocity (Hahn and others 1995, figure 10).
timbre::Tree squeak() {
  using timbre::node;
  timbre::TreeBuilder tree("squeak");
  const timbre::Expression speed = tree.parameter("speed");       // rad/s, zero while it turns the other way
  const timbre::Expression pitch = tree.parameter("pitch", 500);  // Hz, at rest
  const timbre::Expression rasp = tree.define("rasp", 1 + 0.03 * node("perlin", 90));
  const timbre::Expression sawtooth = node("sawtooth", rasp * (pitch + 80 * speed));
  return tree.finish(node("tanh", 0.2 * speed) * node("bandpass", sawtooth, 1800, 0.8));
}

struct World {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broad_phase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld dynamics{&dispatcher, &broad_phase, &solver, &configuration};
  btBoxShape floor{{2, 0.1F, 2}}, arm{{0.02F, 0.2F, 0.02F}}, block{{0.02F, 0.06F, 0.04F}};
  std::deque<btRigidBody> bodies;
  btRigidBody& lamp{add(arm, {0.2F, 0.456F, 0}, 0.4, 1.5F)};  // lifted by 1.5 rad
  btHingeConstraint hinge{lamp, {0, 0.2F, 0}, {0, 0, 1}};

  timbre::Tree knock;
  timbre::LiveSound opening{squeak(), {.live = {{"speed", 0}}, .constants = {{"pitch", 520}}}};
  timbre::LiveSound closing{squeak(), {.live = {{"speed", 0}}, .constants = {{"pitch", 380}}}};
  std::deque<timbre::LiveSound> knocks;
  unsigned contacts = 0;
  double fastest = 0.0;  // rad/s

  explicit World(const char* tree) : knock(timbre::read_tree_file(tree)) {
    dynamics.setGravity({0, -9.81F, 0});
    add(floor, {0, -0.1F, 0}, 0.0);
    for (const float x : {0.0F, -0.1F, -0.2F}) {
      add(block, {x - 0.12F, 0.06F, 0}, 0.2);
    }
    dynamics.addConstraint(&hinge);
  }

  btRigidBody& add(btCollisionShape& shape, const btVector3& at, double mass, float angle = 0.0F) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0.0) shape.calculateLocalInertia(static_cast<btScalar>(mass), inertia);
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass), nullptr, &shape, inertia);
    info.m_startWorldTransform = btTransform(btQuaternion({0, 0, 1}, angle), at);
    info.m_restitution = 0.3F;
    dynamics.addRigidBody(&bodies.emplace_back(info));
    bodies.back().setActivationState(DISABLE_DEACTIVATION);
    return bodies.back();
  }

  /// A new contact starts a sound: the same body, but another noise each time.
  void start_knocks() {
    for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
      const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(m);
      for (int p = 0; p < manifold.getNumContacts(); ++p) {
        const double impulse = manifold.getContactPoint(p).getAppliedImpulse();
        if (manifold.getContactPoint(p).getLifeTime() <= 1 && impulse > least_impulse) {
          knocks.emplace_back(knock,
                              timbre::LiveSoundOptions{.start = contacts++, .constants = {{"impulse", impulse}}});
        }
      }
    }
  }

  void step() {
    dynamics.stepSimulation(1.0F / steps_per_second, 1, 1.0F / steps_per_second);
    const double speed = lamp.getAngularVelocity().z();
    fastest = std::max(fastest, std::abs(speed));
    opening.set("speed", std::max(0.0, speed));
    closing.set("speed", std::max(0.0, -speed));
    start_knocks();
  }

  void render(std::vector<double>& block) {
    std::vector<double> sound(block.size());
    std::ranges::fill(block, 0.0);
    const auto add_sound = [&](timbre::LiveSound& live, double gain) {
      live.render(sound);
      for (std::size_t i = 0; i < block.size(); ++i) block[i] += gain * sound[i];
    };
    add_sound(opening, 0.2);
    add_sound(closing, 0.2);
    for (timbre::LiveSound& live : knocks) add_sound(live, 0.05);
    std::erase_if(knocks, [](const timbre::LiveSound& live) { return live.silent_for() > 0.1; });
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
  const double seconds = count > 3 ? std::atof(arguments[3]) : 4.0;
  World world(arguments[1]);
  std::vector<double> block(samples_per_step);
  for (int step = 0; step < seconds * steps_per_second; ++step) {
    world.step();
    world.render(block);
    sf_write_double(file, block.data(), samples_per_step);
  }
  sf_close(file);
  std::printf("%u contacts sounded; the hinge turned with up to %.1f rad/s\n", world.contacts, world.fastest);
} catch (const std::exception& error) {
  std::fprintf(stderr, "creaking_lamp: %s\n", error.what());
  return 1;
}
