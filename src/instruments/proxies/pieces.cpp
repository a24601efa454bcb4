#include "pieces.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "idiophone/foundation/inertia_tensor.hpp"
#include "masses.hpp"

namespace idiophone::proxies {

namespace {

Vector3 centre_of(const std::vector<Vector3>& nodes, const std::array<Index, 4>& tetrahedron) {
  Vector3 sum = Vector3::Zero();
  for (const Index node : tetrahedron) {
    sum += 0.25 * nodes[node];
  }
  return sum;
}

bool is_ahead(const std::vector<Vector3>& nodes, const std::array<Index, 4>& tetrahedron, Index mass,
              const Vector3& direction) {
  return (centre_of(nodes, tetrahedron) - nodes[mass]).dot(direction) > 0.0;
}

/// Sets that are joined one by one.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  /// One member that stands for the whole set.
  std::size_t root_of(std::size_t member) {
    while (parent_[member] != member) {
      member = parent_[member] = parent_[parent_[member]];
    }
    return member;
  }

  void join(std::size_t a, std::size_t b) { parent_[root_of(a)] = root_of(b); }

 private:
  std::vector<std::size_t> parent_;
};

/// A face of a tetrahedron: its nodes, and which corners of all tetrahedra they are, in the order of the nodes.
struct CornerFace {
  std::array<Index, 3> nodes{};
  std::array<std::size_t, 3> corners{};
};

/// Of all tetrahedra; faces of the same nodes follow each other.
std::vector<CornerFace> faces_of(const std::vector<std::array<Index, 4>>& tetrahedra) {
  std::vector<CornerFace> faces;
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    std::ranges::sort(order, {}, [&](std::size_t corner) { return tetrahedra[t][corner]; });
    for (std::size_t opposite = 0; opposite < 4; ++opposite) {
      CornerFace& face = faces.emplace_back();
      for (std::size_t i = 0, n = 0; i < 4; ++i) {
        if (i != opposite) {
          face.nodes[n] = tetrahedra[t][order[i]];
          face.corners[n++] = 4 * t + order[i];
        }
      }
    }
  }
  std::ranges::sort(faces, {}, [](const CornerFace& face) { return std::pair(face.nodes, face.corners); });
  return faces;
}

}  // namespace

bool can_split(const Lattice& lattice, const Overload& overload) {
  bool is_any_ahead = false, is_any_behind = false;
  const TetrahedralMesh& mesh = lattice.mesh();
  for (const auto& tetrahedron : mesh.tetrahedra) {
    if (std::ranges::find(tetrahedron, overload.a) != tetrahedron.end()) {
      (is_ahead(mesh.nodes, tetrahedron, overload.a, overload.direction) ? is_any_ahead : is_any_behind) = true;
    }
  }
  return is_any_ahead && is_any_behind;
}

Pieces::Pieces(const Fragment& whole)
    : whole_(whole.lattice.get()),
      nodes_(whole_->mesh().nodes),
      displacement_(whole.displacement),
      velocity_(whole.velocity),
      pinned_(whole_->pinned()),
      tetrahedra_(whole_->mesh().tetrahedra),
      origin_(tetrahedra_.size()) {
  std::iota(origin_.begin(), origin_.end(), std::size_t{0});
  const std::vector<double> volume = volumes(whole_->mesh());
  std::vector<double> around(nodes_.size());  // volume of the tetrahedra of each node, m3
  for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
    for (const Index node : tetrahedra_[t]) {
      around[node] += volume[t];
    }
  }
  for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
    auto& shares = shares_.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const Index node = tetrahedra_[t][i];
      shares[i] = whole_->masses()[node] * volume[t] / around[node];
    }
  }
}

Index Pieces::add_node(const Vector3& place, const Vector3& displacement, const Vector3& velocity, bool pinned) {
  nodes_.push_back(place);
  displacement_.push_back(displacement);
  velocity_.push_back(velocity);
  pinned_.push_back(pinned);
  return static_cast<Index>(nodes_.size() - 1);
}

void Pieces::split_mass(Index mass, const Vector3& direction) {
  const Index other =
      add_node(Vector3(nodes_[mass]), Vector3(displacement_[mass]), Vector3(velocity_[mass]), pinned_[mass]);
  for (auto& tetrahedron : tetrahedra_) {
    if (std::ranges::count(tetrahedron, mass) > 0 && is_ahead(nodes_, tetrahedron, mass, direction)) {
      std::ranges::replace(tetrahedron, mass, other);
    }
  }
}

/// Half of the shares of both ends go to the middle, which moves so that the momentum stays the same.
void Pieces::split_spring(Index a, Index b) {
  const Vector3 before = angular_momentum();
  const std::size_t count = tetrahedra_.size();
  double of_a = 0.0, of_b = 0.0;
  std::vector<std::array<std::size_t, 3>> split;  // a tetrahedron, and its corners at a and b
  for (std::size_t t = 0; t < count; ++t) {
    const auto at_a = std::ranges::find(tetrahedra_[t], a), at_b = std::ranges::find(tetrahedra_[t], b);
    if (at_a != tetrahedra_[t].end() && at_b != tetrahedra_[t].end()) {
      split.push_back({t, static_cast<std::size_t>(at_a - tetrahedra_[t].begin()),
                       static_cast<std::size_t>(at_b - tetrahedra_[t].begin())});
      of_a += shares_[t][split.back()[1]];
      of_b += shares_[t][split.back()[2]];
    }
  }
  const Vector3 place = 0.5 * (nodes_[a] + nodes_[b]), displacement = 0.5 * (displacement_[a] + displacement_[b]);
  const Vector3 velocity = (of_a * velocity_[a] + of_b * velocity_[b]) / (of_a + of_b);
  const Index middle_of_a = add_node(place, displacement, velocity, false);
  const Index middle_of_b = add_node(place, displacement, velocity, false);
  for (const auto& [t, corner_a, corner_b] : split) {
    std::array<double, 4> half = shares_[t];
    for (double& share : half) {
      share *= 0.5;
    }
    const double middle = 0.5 * (half[corner_a] + half[corner_b]);
    tetrahedra_.push_back(tetrahedra_[t]);
    shares_.push_back(half);
    origin_.push_back(origin_[t]);
    tetrahedra_[t][corner_b] = middle_of_a;
    tetrahedra_.back()[corner_a] = middle_of_b;
    shares_[t] = half;
    shares_[t][corner_b] = shares_.back()[corner_a] = middle;
  }
  restore_angular_momentum(before);
}

void Pieces::open_hinges() {
  const std::vector<CornerFace> faces = faces_of(tetrahedra_);
  Sets corners(4 * tetrahedra_.size());
  for (std::size_t i = 1; i < faces.size(); ++i) {
    if (faces[i].nodes == faces[i - 1].nodes) {
      for (std::size_t n = 0; n < 3; ++n) {
        corners.join(faces[i].corners[n], faces[i - 1].corners[n]);
      }
    }
  }
  std::map<std::size_t, Index> node_of;  // the groups of corners that have their node
  std::vector<bool> is_taken(nodes_.size());
  for (std::size_t corner = 0; corner < 4 * tetrahedra_.size(); ++corner) {
    Index& node = tetrahedra_[corner / 4][corner % 4];
    const auto [group, is_new] = node_of.try_emplace(corners.root_of(corner), node);
    if (is_new && is_taken[node]) {
      group->second =
          add_node(Vector3(nodes_[node]), Vector3(displacement_[node]), Vector3(velocity_[node]), pinned_[node]);
      is_taken.push_back(true);
    }
    is_taken[node] = true;
    node = group->second;
  }
}

Vector3 Pieces::angular_momentum() const {
  Vector3 sum = Vector3::Zero();
  for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Index node = tetrahedra_[t][i];
      sum += shares_[t][i] * nodes_[node].cross(velocity_[node]);
    }
  }
  return sum;
}

/// Turns all masses a little about their common centre.
void Pieces::restore_angular_momentum(const Vector3& before) {
  std::vector<double> masses(nodes_.size());
  for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
    for (std::size_t i = 0; i < 4; ++i) {
      masses[tetrahedra_[t][i]] += shares_[t][i];
    }
  }
  const Inertia inertia = inertia_of(nodes_, masses);
  const Eigen::Matrix3d tensor = inertia_tensor(inertia.second);
  const Vector3 turn = tensor.inverse() * (before - angular_momentum());
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    velocity_[node] += turn.cross(nodes_[node] - inertia.centre);
  }
}

std::vector<Fragment> Pieces::fragments() const {
  Sets nodes(nodes_.size());
  for (const auto& tetrahedron : tetrahedra_) {
    for (const Index node : tetrahedron) {
      nodes.join(static_cast<std::size_t>(node), static_cast<std::size_t>(tetrahedron[0]));
    }
  }
  std::map<std::size_t, std::vector<std::size_t>> parts;
  for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
    parts[nodes.root_of(static_cast<std::size_t>(tetrahedra_[t][0]))].push_back(t);
  }
  std::vector<Fragment> fragments;
  fragments.reserve(parts.size());
  for (const auto& [root, tetrahedra] : parts) {
    fragments.push_back(fragment_of(tetrahedra));
  }
  return fragments;
}

Fragment Pieces::fragment_of(const std::vector<std::size_t>& tetrahedra) const {
  Fragment fragment;
  TetrahedralMesh mesh;
  OwnValues own;
  std::vector<Index> pinned;
  std::vector<Index> number(nodes_.size(), -1);
  for (const std::size_t t : tetrahedra) {
    auto& corners = mesh.tetrahedra.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      const Index node = tetrahedra_[t][i];
      if (number[node] < 0) {
        number[node] = static_cast<Index>(mesh.nodes.size());
        mesh.nodes.push_back(nodes_[node]);
        own.masses.push_back(0.0);
        fragment.displacement.push_back(displacement_[node]);
        fragment.velocity.push_back(velocity_[node]);
        if (pinned_[node]) {
          pinned.push_back(number[node]);
        }
      }
      corners[i] = number[node];
      own.masses[number[node]] += shares_[t][i];
    }
    own.stiffness.push_back(whole_->own_stiffness(origin_[t]));
    own.edges.push_back(whole_->own_edges(origin_[t]));
    own.damping.push_back(whole_->own_damping(origin_[t]));
    const std::vector<std::size_t>& before = whole_->mesh().origin;
    mesh.origin.push_back(before.empty() ? origin_[t] : before[origin_[t]]);
  }
  mesh.surface = exterior_triangles(mesh.nodes, mesh.tetrahedra);
  if (pinned.size() < 3) {
    pinned.clear();
  }
  fragment.lattice = std::make_shared<Lattice>(std::move(mesh), whole_->material(), pinned, std::move(own));
  return fragment;
}

}  // namespace idiophone::proxies
