// many_bodies FILE.wav BODIES SECONDS BUDGET FILE.voice|FILE.proxy...: bodies with sound maps or proxies fall into a
// pit. Bullet moves them as boxes with 60 steps per second. Each second, a row of numbers says what is heard and what
// it costs.

#include <btBulletDynamicsCommon.h>
#include <sndfile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <deque>
#include <memory>
#include <variant>

#include "idiophone/instruments/engines/engine_stage.hpp"

namespace engines = idiophone::engines;
using engines::ContactEvent;

constexpr int rate = 48000, steps_per_second = 60, frames = rate / steps_per_second, channels = 2;
constexpr double full_scale = 20.0;  // Pa, that becomes 1.0 in the file

/// How a body sounds.
using Sound = std::variant<engines::SharedMap, engines::SharedProxy>;

Sound read_sound(const std::filesystem::path& file) {
  if (file.extension() == ".proxy") return engines::read_proxy(file);
  return engines::read_map(file);
}

engines::BodyFacts facts_of(const Sound& sound) {
  return std::visit([](const auto& one) { return engines::facts_of(one); }, sound);
}

engines::Triple from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

btVector3 to_bullet(const engines::Triple& v) {
  return {static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2])};
}

class Pit {
 public:
  Pit(const std::vector<Sound>& sounds, int count) {
    dynamics_.setGravity({0, 0, -9.81F});
    add(ground_, {0, 0, -0.1F}, 0.0);
    for (int side = 0; side < 4; ++side) {
      const float x = std::array{1.1F, -1.1F, 0.0F, 0.0F}[side], y = std::array{0.0F, 0.0F, 1.1F, -1.1F}[side];
      add(side < 2 ? wall_x_ : wall_y_, {x, y, 0.5F}, 0.0);
    }
    for (int i = 0; i < count; ++i) {
      const engines::BodyFacts facts = facts_of(sounds[i % sounds.size()]);
      const btVector3 half = (to_bullet(facts.high) - to_bullet(facts.low)) / 2;
      btBoxShape& box = boxes_.emplace_back(half + btVector3(0.002F, 0.002F, 0.002F));
      const auto layer = static_cast<float>(i / 16);
      add(box, {0.4F * (i % 4) - 0.6F, 0.4F * (i / 4 % 4) - 0.6F, 0.6F + 0.4F * layer}, facts.mass).setUserIndex(i);
      centres_.push_back(to_bullet(facts.centre));
    }
  }

  void move() { dynamics_.stepSimulation(1.0 / steps_per_second, 1, 1.0 / steps_per_second); }

  /// Tells the stage where the bodies are and how they touch.
  void tell(engines::EngineStage& stage) {
    for (const btRigidBody& body : bodies_) {
      if (body.getUserIndex() >= 0) {
        const btTransform& place = body.getWorldTransform();
        const btQuaternion turn = place.getRotation();
        stage.place(body.getUserIndex(), {.position = from_bullet(place * -centres_[body.getUserIndex()]),
                                          .turn = {turn.x(), turn.y(), turn.z(), turn.w()}});
      }
    }
    for (int m = 0; m < dispatcher_.getNumManifolds(); ++m) {
      tell(*dispatcher_.getManifoldByIndexInternal(m), stage);
    }
    stage.step(1.0 / steps_per_second);
  }

 private:
  btRigidBody& add(btBoxShape& shape, const btVector3& at, double mass) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0.0) shape.calculateLocalInertia(mass, inertia);
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_startWorldTransform = btTransform(btQuaternion(0.3, 0.2, 0.1), at);
    if (mass == 0.0) info.m_startWorldTransform.setRotation(btQuaternion::getIdentity());
    info.m_restitution = 0.3;
    dynamics_.addRigidBody(&bodies_.emplace_back(info));
    bodies_.back().setUserIndex(ContactEvent::nobody);
    return bodies_.back();
  }

  /// The points of a manifold are one contact, at the point with the greatest impulse.
  static void tell(const btPersistentManifold& manifold, engines::EngineStage& stage) {
    const auto& first = static_cast<const btRigidBody&>(*manifold.getBody0());
    const auto& second = static_cast<const btRigidBody&>(*manifold.getBody1());
    ContactEvent event{.contact = reinterpret_cast<std::uintptr_t>(&manifold),
                       .bodies = {first.getUserIndex(), second.getUserIndex()}};
    event.surfaces = {event.bodies[0] < 0 ? 1 : 0, event.bodies[1] < 0 ? 1 : 0};
    double strongest = 0.0;
    for (int p = 0; p < manifold.getNumContacts(); ++p) {
      const btManifoldPoint& point = manifold.getContactPoint(p);
      event.impulse += point.getAppliedImpulse();
      if (point.getAppliedImpulse() > strongest) {
        strongest = point.getAppliedImpulse();
        const btVector3 at = point.getPositionWorldOnB(), normal = point.m_normalWorldOnB;
        const btVector3 over = first.getVelocityInLocalPoint(at - first.getWorldTransform().getOrigin()) -
                               second.getVelocityInLocalPoint(at - second.getWorldTransform().getOrigin());
        event.phase = point.getLifeTime() <= 1 ? ContactEvent::Phase::begin : ContactEvent::Phase::persist;
        event.point = from_bullet(at);
        event.normal = from_bullet(normal);
        event.slip = from_bullet(over - over.dot(normal) * normal);
      }
    }
    if (strongest > 0.0 && std::max(event.bodies[0], event.bodies[1]) >= 0) stage.contact(event);
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld dynamics_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
  btBoxShape ground_{{1.2F, 1.2F, 0.1F}}, wall_x_{{0.1F, 1.2F, 3.0F}}, wall_y_{{1.2F, 0.1F, 3.0F}};
  std::deque<btBoxShape> boxes_;
  std::deque<btRigidBody> bodies_;
  std::vector<btVector3> centres_;
};

/// Adds the processor time of some work to a sum, s.
template <class Work>
void measure(double& sum, const Work& work) {
  const std::clock_t begin = std::clock();
  work();
  sum += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

int fall(SNDFILE* file, int count, double seconds, double budget, const std::vector<Sound>& sounds) {
  const engines::BodyFacts facts = facts_of(sounds.front());
  const engines::Surface body{.young = facts.young, .poisson = facts.poisson, .radius = 0.01};
  const engines::Surface wood{.young = 1e10, .radius = 0.1, .height = 1e-5};
  engines::EngineStage stage({.rate = rate,
                              .ears = {{-0.1, -2, 1}, {0.1, -2, 1}},
                              .latency = 0,
                              .budget = budget,
                              .speed = engines::measured_speed()},
                             {}, {body, wood});
  for (int i = 0; i < count; ++i) {
    std::visit([&](const auto& one) { stage.add(one); }, sounds[i % sounds.size()]);
  }
  Pit pit(sounds, count);
  std::vector<float> sound(frames * channels);
  double bullet = 0.0, control = 0.0, audio = 0.0;
  std::printf("second  sounding  heard/modes  cost  render  step  Bullet  loss/dB  strokes  impacts  left out\n");
  for (int step = 1; step <= seconds * steps_per_second; ++step) {
    measure(bullet, [&] { pit.move(); });
    measure(control, [&] { pit.tell(stage); });
    measure(audio, [&] { stage.render(sound, full_scale); });
    sf_writef_float(file, sound.data(), frames);
    if (step % steps_per_second == 0) {
      const engines::StageReport report = stage.report();
      std::printf("%6d  %8zu  %5zu/%5zu  %4.2f  %6.2f  %4.2f  %6.2f  %7.1f  %7zu  %7ju  %8ju\n",
                  step / steps_per_second, report.sounding + report.proxies, report.heard, report.modes,
                  report.cost + report.proxy_cost, audio, control, bullet,
                  10.0 * std::log10(std::max(report.loss, 1e-12)), report.strokes,
                  static_cast<std::uintmax_t>(report.impacts), static_cast<std::uintmax_t>(report.left_out));
      bullet = control = audio = 0.0;
    }
  }
  return 0;
}

int main(int count, char** arguments) {
  if (count < 6) {
    std::fprintf(stderr, "usage: many_bodies FILE.wav BODIES SECONDS BUDGET FILE.voice|FILE.proxy...\n");
    return 1;
  }
  SF_INFO format{.frames = 0,
                 .samplerate = rate,
                 .channels = channels,
                 .format = SF_FORMAT_WAV | SF_FORMAT_FLOAT,
                 .sections = 0,
                 .seekable = 0};
  const std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> file(sf_open(arguments[1], SFM_WRITE, &format), sf_close);
  if (!file) {
    std::fprintf(stderr, "can't write %s\n", arguments[1]);
    return 1;
  }
  try {
    std::vector<Sound> sounds;
    for (int i = 5; i < count; ++i) sounds.push_back(read_sound(arguments[i]));
    return fall(file.get(), std::atoi(arguments[2]), std::atof(arguments[3]), std::atof(arguments[4]), sounds);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
