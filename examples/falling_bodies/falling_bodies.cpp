// falling_bodies FILE.wav [SECONDS]: boxes and bells fall down stairs. Bullet moves them with 60 steps per second. Each
// contact strikes the proxies of its bodies.

#include <btBulletDynamicsCommon.h>
#include <sndfile.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <numbers>

#include "idiophone/instruments/proxies/engine.hpp"
#include "idiophone/instruments/proxies/lasting_contact.hpp"

namespace proxies = idiophone::proxies;
using idiophone::Vector3;
using Levels = std::vector<std::shared_ptr<const proxies::Lattice>>;

constexpr int rate = 44100, steps_per_second = 60, samples_per_step = rate / steps_per_second;
constexpr double full_scale = 60.0;  // Pa, that becomes 1.0 in the file
constexpr double size = 0.12;        // m, of all bodies
const proxies::Damping damping = proxies::damping_for({300.0, 3000.0}, {0.3, 0.1});
const proxies::Material wood{.young = 2e8, .density = 600.0, .damping = damping};  // soft, so that it is fast
const proxies::Material bronze{
    .young = 2e9, .density = 8000.0, .damping = proxies::damping_for({300.0, 3000.0}, {2.0, 0.5})};

Vector3 from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

/// A cube around the origin, in two levels of detail.
Levels box() {
  Levels levels;
  for (const int cells : {4, 2}) {
    const auto place = [](const Vector3& at) { return Vector3(size * (at - Vector3::Constant(0.5))); };
    levels.push_back(std::make_shared<proxies::Lattice>(proxies::grid_mesh({cells, cells, cells}, place), wood));
  }
  return levels;
}

/// A bell with its axis along y: a wall whose radius grows towards the mouth.
Levels bell() {
  Levels levels;
  for (const int cells : {16, 8}) {
    const auto place = [](const Vector3& at) {
      const double angle = 2.0 * std::numbers::pi * at[0];
      const double radius = 0.5 * size * (0.55 + 0.45 * at[1] * at[1]) - 0.08 * size * at[2];
      return Vector3(radius * std::cos(angle), size * (0.5 - at[1]), radius * std::sin(angle));
    };
    levels.push_back(std::make_shared<proxies::Lattice>(
        proxies::grid_mesh({cells, cells / 2, 1}, place, proxies::Seam::closed), bronze));
  }
  return levels;
}

struct World {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broad_phase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld dynamics{&dispatcher, &broad_phase, &solver, &configuration};
  btBoxShape cube{btVector3(size, size, size) / 2}, stair{btVector3(1.0, 0.1, 0.2)};
  btCylinderShape cylinder{btVector3(size, size, size) / 2};
  std::deque<btRigidBody> bodies;
  proxies::Engine engine{{.rate = rate, .priority = proxies::Priority::loudness, .most_active = 8, .budget = 3e9}};

  World() {
    dynamics.setGravity({0, -9.81, 0});
    for (int step = 0; step < 8; ++step) {
      add(stair, {0.0F, -0.2F * step, 0.4F * step}, 0.0).setUserIndex(-1);  // silent
    }
    const Levels boxes = box(), bells = bell();
    for (int i = 0; i < 8; ++i) {
      const bool is_bell = i % 2 == 1;
      const Levels& levels = is_bell ? bells : boxes;
      btRigidBody& body = add(is_bell ? static_cast<btCollisionShape&>(cylinder) : cube,
                              {-0.6F + 0.17F * i, 0.5F + 0.2F * i, -0.05F}, levels[0]->inertia().mass);
      body.setUserIndex(static_cast<int>(engine.add({.name = is_bell ? "bell" : "box", .levels = levels})));
      body.setLinearVelocity({0, 0, 0.8});
    }
  }

  btRigidBody& add(btCollisionShape& shape, const btVector3& at, double mass) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0.0) shape.calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_startWorldTransform = btTransform(btQuaternion(0.3 * mass, 0.2, 0.1), at);
    info.m_restitution = 0.4;
    dynamics.addRigidBody(&bodies.emplace_back(info));
    return bodies.back();
  }

  /// A new contact is an impact of 0.5 ms. One that lasts is a force without clicks.
  void strike(const btCollisionObject& body, const btVector3& at, const btVector3& impulse, bool is_new) {
    if (body.getUserIndex() < 0) return;
    const auto number = static_cast<std::size_t>(body.getUserIndex());
    const Vector3 turned = from_bullet(body.getWorldTransform().getBasis().transpose() * impulse);
    engine.add(is_new
                   ? proxies::impact(number, engine.now(), from_bullet(at), turned, 5e-4, rate)
                   : proxies::lasting_contact(number, engine.now(), from_bullet(at), turned, samples_per_step, rate));
  }

  void step() {
    dynamics.stepSimulation(1.0 / steps_per_second, 1, 1.0 / steps_per_second);
    for (int m = 0; m < dispatcher.getNumManifolds(); ++m) {
      const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(m);
      for (int p = 0; p < manifold.getNumContacts(); ++p) {
        const btManifoldPoint& point = manifold.getContactPoint(p);
        const btVector3 impulse = point.getAppliedImpulse() * point.m_normalWorldOnB;
        if (impulse.length2() > 0) {
          const bool is_new = point.getLifeTime() <= 1;
          strike(*manifold.getBody0(), point.m_localPointA, impulse, is_new);
          strike(*manifold.getBody1(), point.m_localPointB, -impulse, is_new);
        }
      }
    }
    for (const btRigidBody& body : bodies) {  // the listener stands before the stairs
      if (body.getUserIndex() >= 0) {
        const btVector3 ear = body.getWorldTransform().inverse() * btVector3(0, 0.5, 4);
        engine.move_listener(static_cast<std::size_t>(body.getUserIndex()), from_bullet(ear));
      }
    }
  }
};

int main(int count, char** arguments) {
  const double seconds = count > 2 ? std::atof(arguments[2]) : 4.0;
  SF_INFO format{.frames = 0,
                 .samplerate = rate,
                 .channels = 1,
                 .format = SF_FORMAT_WAV | SF_FORMAT_FLOAT,
                 .sections = 0,
                 .seekable = 0};
  SNDFILE* file = count > 1 ? sf_open(arguments[1], SFM_WRITE, &format) : nullptr;
  if (file == nullptr) {
    std::fprintf(stderr, "usage: falling_bodies FILE.wav [SECONDS]\n");
    return 1;
  }
  World world;
  std::vector<double> block(samples_per_step);
  for (int step = 0; step < seconds * steps_per_second; ++step) {
    world.step();
    world.engine.render(block);
    for (double& sample : block) sample /= full_scale;
    sf_write_double(file, block.data(), samples_per_step);
  }
  sf_close(file);
  std::size_t refused = 0;
  const auto choices = world.engine.take_choices();
  for (const proxies::Choice& choice : choices) refused += choice.kind == proxies::Choice::Kind::refuse ? 1 : 0;
  std::printf("%zu choices of levels, %zu forces left out\n", choices.size(), refused);
}
