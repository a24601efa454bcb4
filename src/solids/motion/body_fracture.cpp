#include "idiophone/solids/motion/body_fracture.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "face_area.hpp"
#include "idiophone/foundation/disjoint_sets.hpp"
#include "idiophone/foundation/each_once.hpp"
#include "idiophone/solids/motion/kick.hpp"

namespace idiophone::motion {

namespace {

/// The same faces in local numbers; none where this rank does not own their nodes.
std::vector<mesh::FractureFace> local_faces(std::span<const mesh::FractureFace> faces, const mesh::Part& part) {
  const auto owned = std::span(part.node_ids).first(part.owned_nodes);
  if (faces.empty() || !std::ranges::binary_search(owned, faces.front().nodes[0][0])) {
    return {};
  }
  std::vector<mesh::FractureFace> local(faces.begin(), faces.end());
  for (mesh::FractureFace& face : local) {
    for (auto& side : face.nodes) {
      for (Index& node : side) {
        node = static_cast<Index>(std::ranges::lower_bound(owned, node) - owned.begin());
      }
    }
  }
  return local;
}

std::vector<Index> all_nodes(std::span<const mesh::FractureFace> faces) {
  std::vector<Index> nodes;
  for (const mesh::FractureFace& face : faces) {
    for (const auto& side : face.nodes) {
      nodes.insert(nodes.end(), side.begin(), side.end());
    }
  }
  keep_each_once(nodes);
  return nodes;
}

Vector3 velocity_of(const NodeState& node) {
  return Vector3(node.velocity);
}

}  // namespace

BodyFracture::BodyFracture(const scene::Solids& solids, std::size_t body, std::span<const mesh::FractureFace> faces,
                           const mesh::Part& part, std::span<const double> masses, std::span<const Index> held)
    : part_(part),
      body_(body),
      name_(solids.bodies[body].name),
      mass_damping_(solids.materials[solids.bodies[body].material].damping.of_all_motion()),
      global_faces_(faces.size()) {
  const std::vector<mesh::FractureFace> local = local_faces(faces, part);
  add_joints(all_nodes(local), masses, held);
  for (const mesh::FractureFace& face : local) {
    add_face(face, solids.bodies[body].fracture[face.surface]);
  }
  broken_.resize(faces_.size());
  cohesions_.resize(faces_.size());
  join_nodes();
}

void BodyFracture::add_joints(const std::vector<Index>& nodes, std::span<const double> masses,
                              std::span<const Index> held) {
  for (const Index node : nodes) {  // those in one place follow one another (mesh::divide)
    if (joints_.empty() || part_.reference[joints_.back().nodes.front()] != part_.reference[node]) {
      joints_.emplace_back();
    }
    joints_.back().nodes.push_back(node);
    joints_.back().masses.push_back(masses[node - part_.bodies[body_].owned_begin]);
  }
  const auto is_free = [&](Index node) {
    const auto next = std::ranges::lower_bound(held, 3 * node);
    return next == held.end() || *next >= 3 * (node + 1);
  };
  for (Joint& joint : joints_) {
    joint.is_measured = joint.nodes.size() == 2 && std::ranges::all_of(joint.nodes, is_free);
  }
}

void BodyFracture::add_face(const mesh::FractureFace& face, const scene::FractureSurface& law) {
  Face& added = faces_.emplace_back();
  added.law = law;
  added.corners.assign(face.nodes[0].begin(), face.nodes[0].begin() + static_cast<std::ptrdiff_t>(face.corners));
  added.area = area_vector(added.corners, [&](Index node) { return part_.reference[node]; }).norm();
  added.shares = face.shares;
  for (std::size_t k = 0; k < face.shares.size(); ++k) {
    const Index node = face.nodes[0][k];
    const auto after = std::ranges::upper_bound(joints_, node, {}, [](const Joint& joint) { return joint.nodes[0]; });
    const Joint& joint = *(after - 1);
    added.joints.push_back(after - 1 - joints_.begin());
    for (std::size_t side = 0; side < 2; ++side) {
      const auto place = std::ranges::find(joint.nodes, face.nodes.at(side)[k]);
      added.places.at(side).push_back(static_cast<Index>(place - joint.nodes.begin()));
    }
    added.weight += joint.is_measured ? face.shares[k] : 0.0;
  }
}

void BodyFracture::join(const Step& step, std::span<NodeState> state) {
  const double gain = kick_of(step, mass_damping_, Vector3::Zero()).gain;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    hold_together(f, gain, state);
  }
  for (Joint& joint : joints_) {
    if (joint.is_measured && joint.leaders[1] == 0) {
      const double mass = joint.masses[0] * joint.masses[1] / (joint.masses[0] + joint.masses[1]);
      joint.force = mass / gain * (velocity_of(state[joint.nodes[1]]) - velocity_of(state[joint.nodes[0]]));
    }
  }
  for (const std::size_t face : break_faces(state)) {
    hold_together(face, gain, state);
  }
  press(state);
  for_each_group([&](const std::vector<Index>& nodes, const std::vector<double>& masses, double mass) {
    const Vector3 first = velocity_of(state[nodes[0]]);
    Vector3 common = first;  // exact where all have the same velocity
    for (std::size_t n = 1; n < nodes.size(); ++n) {
      common += masses[n] / mass * (velocity_of(state[nodes[n]]) - first);
    }
    for (const Index node : nodes) {
      std::copy_n(common.data(), 3, state[node].velocity);
    }
  });
}

void BodyFracture::share(std::span<NodeForce> force) const {
  for_each_group([&](const std::vector<Index>& nodes, const std::vector<double>& masses, double mass) {
    Vector3 sum = Vector3::Zero();
    for (const Index node : nodes) {
      sum += Vector3(force[node].component);
    }
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const Vector3 part = masses[n] / mass * sum;
      std::copy_n(part.data(), 3, force[nodes[n]].component);
    }
  });
}

void BodyFracture::join_nodes() {
  for (Joint& joint : joints_) {
    joint.leaders.resize(joint.nodes.size());
    std::iota(joint.leaders.begin(), joint.leaders.end(), 0);
    joint.area = 0.0;
  }
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (broken_[f] != 0) {
      continue;
    }
    for (std::size_t k = 0; k < faces_[f].joints.size(); ++k) {
      Joint& joint = joints_[faces_[f].joints[k]];
      joint.area += faces_[f].area;
      const auto [leader, follower] =
          std::minmax({joint.leaders[faces_[f].places[0][k]], joint.leaders[faces_[f].places[1][k]]});
      std::ranges::replace(joint.leaders, follower, leader);
    }
  }
}

template <class Visitor>
void BodyFracture::for_each_group(Visitor visit) const {
  std::vector<Index> nodes;
  std::vector<double> masses;
  for (const Joint& joint : joints_) {
    for (std::size_t leader = 0; leader < joint.nodes.size(); ++leader) {
      nodes.clear();
      masses.clear();
      for (std::size_t n = leader; n < joint.nodes.size(); ++n) {
        if (joint.leaders[n] == static_cast<Index>(leader)) {
          nodes.push_back(joint.nodes[n]);
          masses.push_back(joint.masses[n]);
        }
      }
      if (nodes.size() > 1) {
        visit(nodes, masses, std::accumulate(masses.begin(), masses.end(), 0.0));
      }
    }
  }
}

double BodyFracture::broken_area() const {
  double area = 0.0;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    area += broken_[f] != 0 ? faces_[f].area : 0.0;
  }
  return area;
}

std::vector<Index> BodyFracture::joined_pieces() const {
  std::vector<Index> first(part_.piece_count(body_));
  if (faces_.empty() || first.empty()) {
    return first;
  }
  DisjointSets joined(first.size());
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (broken_[f] == 0) {
      const auto [near, far] = pair_of(faces_[f], 0);
      joined.join(part_.pieces[near] - part_.first_piece[body_], part_.pieces[far] - part_.first_piece[body_]);
    }
  }
  for (std::size_t piece = 0; piece < first.size(); ++piece) {
    first[piece] = joined.root(static_cast<Index>(piece)) + 1;
  }
  return first;
}

void BodyFracture::archive(parallel::Archive& archive) {
  std::vector<Index> numbers(faces_.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  const parallel::Rows rows(numbers, static_cast<std::int64_t>(global_faces_), archive.communicator());
  archive.rows("motion/fracture/" + name_, rows, [this](std::size_t face, parallel::ArchiveRow& row) {
    row.value(broken_[face]);
    auto& [stress, widest, opening] = cohesions_[face];
    for (double& component : stress) {
      row.value(component);
    }
    row.value(widest);
    row.value(opening);
  });
  join_nodes();
}

}  // namespace idiophone::motion
