// Bodies that break: their pieces become bodies, which fall.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "idiophone/foundation/each_once.hpp"
#include "idiophone/foundation/inertia_tensor.hpp"
#include "idiophone/instruments/voices/proxy_voices.hpp"

namespace idiophone::voices {

namespace {

constexpr double short_time = 1e-4;  // s: in which the velocity of a track is measured

RigidPiece rigid_piece(const proxies::Lattice& lattice) {
  RigidPiece piece{
      .mass = lattice.inertia().mass, .centre = lattice.inertia().centre, .second = lattice.inertia().second};
  std::vector<Index> nodes;
  for (const auto& triangle : lattice.mesh().surface) {
    nodes.insert(nodes.end(), triangle.begin(), triangle.end());
  }
  keep_each_once(nodes);
  for (const Index node : nodes) {
    piece.points.push_back(lattice.mesh().nodes[node]);
  }
  return piece;
}

/// The force of an impact on a floor.
proxies::Force force_of(std::size_t body, const Landing& landing, double hardness, int rate) {
  const score::Hammer as_hammer{.mass = landing.mass, .hardness = hardness, .speed = landing.speed};
  return proxies::impact(body, std::llround(landing.time * rate), landing.at, landing.impulse,
                         as_hammer.contact_duration(), rate);
}

}  // namespace

void ProxyVoices::take_fractures() {
  for (const proxies::Fracture& fracture : engine_.take_fractures()) {
    add_pieces(fracture);
  }
}

/// A free piece goes on from where the body was, with the motion that it got. A held one stays with the body.
void ProxyVoices::add_pieces(const proxies::Fracture& fracture) {
  const drivers::BodyTrack track = bodies_[fracture.body].track;
  const std::size_t root = roots_[fracture.body];
  const double time = static_cast<double>(fracture.sample) / hearing_.rate;
  const Movement whole = movement(fracture.body, time);
  falling_.erase(fracture.body);
  for (const proxies::Piece& piece : fracture.pieces) {
    if (!piece.body) {
      continue;
    }
    bodies_.push_back({.name = fmt::format("{}.{}", names_[root], std::ranges::count(roots_, root)),
                       .centre = piece.centre,
                       .track = track});
    roots_.push_back(root);
    if (engine_.body(*piece.body).levels.front()->is_free()) {
      let_fall(piece, whole, time);
    }
  }
  fractures_.push_back(fracture);
}

ProxyVoices::Movement ProxyVoices::movement(std::size_t body, double time) const {
  if (const auto found = falling_.find(body); found != falling_.end()) {
    const FallingPiece& piece = *found->second;
    const RigidState now = piece.at(time);
    return {.pose = piece.pose(time), .centre = now.centre, .velocity = now.velocity, .spin = piece.spin(now)};
  }
  const auto& [name, centre, track] = bodies_[body];
  if (!track) {
    return {
        .pose = Eigen::Isometry3d::Identity(), .centre = centre, .velocity = Vector3::Zero(), .spin = Vector3::Zero()};
  }
  const Eigen::Isometry3d now = track(time), before = track(time - short_time);
  const Eigen::AngleAxisd turned(now.linear() * before.linear().transpose());
  return {.pose = now,
          .centre = now * centre,
          .velocity = (now * centre - before * centre) / short_time,
          .spin = turned.angle() / short_time * turned.axis()};
}

void ProxyVoices::let_fall(const proxies::Piece& piece, const Movement& whole, double time) {
  RigidPiece rigid = rigid_piece(*engine_.body(*piece.body).levels.front());
  const Eigen::Matrix3d inertia = inertia_tensor(rigid.second);
  RigidState state{.centre = whole.pose * rigid.centre, .turn = Eigen::Quaterniond(whole.pose.linear())};
  state.velocity = whole.velocity + whole.spin.cross(state.centre - whole.centre) + state.turn * piece.motion.velocity;
  const Vector3 spin = state.turn.conjugate() * whole.spin + piece.motion.angular_velocity;
  state.angular_momentum = state.turn * (inertia * spin);
  const auto falling = std::make_shared<FallingPiece>(std::move(rigid), state, time, ground_);
  bodies_[*piece.body].track = [falling](double at) { return falling->pose(at); };
  falling_[*piece.body] = falling;
}

/// The engine gets them before it computes these samples.
void ProxyVoices::add_landings(std::size_t samples) {
  const double end = static_cast<double>(engine_.now() + static_cast<std::int64_t>(samples)) / hearing_.rate;
  for (const auto& [body, piece] : falling_) {
    for (const Landing& landing : piece->advance(end)) {
      engine_.add(force_of(body, landing, ground_.hardness, hearing_.rate));
    }
  }
}

}  // namespace idiophone::voices
