// All contacts of a scene: an impact, and the same forces on any number of ranks.

#include "idiophone/solids/contact/contacts.hpp"

#include <gtest/gtest.h>

#include "block_mesh.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/scene/scene.hpp"
#include "memory_archive.hpp"
#include "ranks.hpp"

namespace idiophone::contact {
namespace {

constexpr double dt = 1e-3;  // s

/// The first mesh with the second one as a further piece.
mesh::Mesh joined(mesh::Mesh first, const mesh::Mesh& second) {
  const auto nodes = static_cast<Index>(first.nodes.size());
  first.nodes.insert(first.nodes.end(), second.nodes.begin(), second.nodes.end());
  const auto behind = [=](Index node) { return node + nodes; };
  std::ranges::transform(second.elements, std::back_inserter(first.elements), behind);
  for (const auto& [a, b, c] : second.surface) {
    first.surface.push_back({behind(a), behind(b), behind(c)});
  }
  first.groups.clear();
  return first;
}

/// Two cubes of 1 m, one above the other with a gap, of 1 kg each, with one contact. `as_one` makes them pieces of one
/// body that touches itself.
class TwoCubes {
 public:
  /// @param cells  along each edge
  explicit TwoCubes(MPI_Comm communicator, scene::Contact contact = {}, int cells = 2, bool as_one = false)
      : communicator_(communicator) {
    std::vector<mesh::Mesh> meshes;
    for (const double height : {0.0, 1.01}) {
      mesh::Mesh mesh = support::block_mesh(element::tet4, {1, 1, 1}, {cells, cells, cells});
      for (Vector3& node : mesh.nodes) {
        node.z() += height;
      }
      meshes.push_back(std::move(mesh));
    }
    per_cube_ = static_cast<Index>(meshes[0].nodes.size());
    if (as_one) {
      meshes = {joined(meshes[0], meshes[1])};
    }
    scene_.bodies.resize(meshes.size());
    contact.name = "hit";
    contact.body = 0;
    contact.other = meshes.size() - 1;
    scene_.contacts = {contact};
    surfaces_ = find_contact_surfaces(scene_, meshes);
    surfaces_.stiffness = {1000.0};
    part_ = mesh::distribute(parallel::is_root(communicator) ? meshes : std::vector<mesh::Mesh>{}, communicator);
    contacts_ = std::make_unique<Contacts>(scene_, part_, surfaces_, dt, 4, communicator);
    state_.resize(part_.node_ids.size());
  }

  /// Moves both cubes as they are, and computes the forces at the next step.
  void compute(const std::array<Vector3, 2>& shift, const std::array<Vector3, 2>& velocity,
               BondUpdate bonds = BondUpdate::stretch) {
    for (std::size_t node = 0; node < state_.size(); ++node) {
      const auto cube = static_cast<std::size_t>(part_.node_ids[node] / per_cube_);
      for (int axis = 0; axis < 3; ++axis) {
        // Not quite rigid, so that no two nodes have the same force.
        state_[node].displacement[axis] = shift.at(cube)[axis] + 1e-4 * std::sin(7.0 * part_.node_ids[node] + axis);
        state_[node].velocity[axis] = velocity.at(cube)[axis];
      }
    }
    contacts_->compute_forces(step_++, state_, bonds);
  }

  /// The forces on all nodes, [3 x global nodes]; each is from the rank that owns the node.
  [[nodiscard]] std::vector<double> forces() const {
    std::vector<solid::NodeForce> force(state_.size());
    contacts_->add_force(force);
    std::vector<double> all(static_cast<std::size_t>(3 * part_.global_nodes));
    for (Index node = 0; node < part_.owned_nodes; ++node) {
      for (int axis = 0; axis < 3; ++axis) {
        all[3 * part_.node_ids[node] + axis] = force[node].component[axis];
      }
    }
    MPI_Allreduce(MPI_IN_PLACE, all.data(), static_cast<int>(all.size()), MPI_DOUBLE, MPI_SUM, communicator_);
    return all;
  }

  /// On one of the cubes.
  [[nodiscard]] Vector3 force_on(std::size_t cube) const {
    const std::vector<double> all = forces();
    Vector3 sum = Vector3::Zero();
    for (Index node = 0; node < per_cube_; ++node) {
      sum += Eigen::Map<const Vector3>(&all[3 * (static_cast<Index>(cube) * per_cube_ + node)]);
    }
    return sum;
  }

  /// From the one rank that reports it.
  [[nodiscard]] double energy() const {
    double energy = contacts_->energy(0);
    MPI_Allreduce(MPI_IN_PLACE, &energy, 1, MPI_DOUBLE, MPI_SUM, communicator_);
    return energy;
  }

  /// That the contact reports, from the one rank that does.
  [[nodiscard]] Vector3 reported_force() const {
    Vector3 force = contacts_->now(0).force;
    MPI_Allreduce(MPI_IN_PLACE, force.data(), 3, MPI_DOUBLE, MPI_SUM, communicator_);
    return force;
  }

  void archive(support::MemoryArchive& archive) {
    std::vector<Index> owned(part_.node_ids.begin(), part_.node_ids.begin() + part_.owned_nodes);
    contacts_->archive(archive, parallel::Rows(owned, part_.global_nodes, communicator_));
  }

  [[nodiscard]] Contacts& contacts() { return *contacts_; }

 private:
  MPI_Comm communicator_;
  scene::Scene scene_;
  ContactSurfaces surfaces_;
  mesh::Part part_;
  std::unique_ptr<Contacts> contacts_;
  std::vector<solid::NodeState> state_;
  Index per_cube_ = 0;
  std::int64_t step_ = 0;
};

scene::Contact rough() {
  scene::Contact contact;
  contact.friction = {0.5, 0.3};
  contact.damping = 1e-3;
  return contact;
}

scene::Contact rough_with_memory() {
  scene::Contact contact = rough();
  contact.friction.memory = friction::Law{.stiffness = 200.0, .damping = 0.1, .viscosity = 0.1};
  return contact;
}

/// The same motion of the same cubes on all ranks together and on each one alone.
void expect_the_same_bits(const scene::Contact& contact) {
  TwoCubes shared(MPI_COMM_WORLD, contact), alone(MPI_COMM_SELF, contact);
  Vector3 largest = Vector3::Zero();
  for (int step = 0; step < 40; ++step) {
    const double depth = 0.05 * std::sin(0.1 * step);
    const std::array<Vector3, 2> shift = {Vector3(0.3, 0.2, 0.0), Vector3(0.003 * step, 0, -depth)};
    const std::array<Vector3, 2> velocity = {Vector3(0, 0, 0), Vector3(3, 0, -5 * std::cos(0.1 * step))};
    shared.compute(shift, velocity);
    alone.compute(shift, velocity);
    ASSERT_EQ(shared.forces(), alone.forces()) << step;
    ASSERT_EQ(shared.energy(), alone.energy()) << step;
    largest = largest.cwiseMax(alone.force_on(1).cwiseAbs());
  }
  EXPECT_GT(largest.z(), 10.0);
  EXPECT_GT(largest.x(), 1.0);  // friction
}

ON_RANKS(1, 3);

TEST(Contacts, ForcesHaveTheSameBitsOnAnyNumberOfRanks) {
  expect_the_same_bits(rough());
  expect_the_same_bits(rough_with_memory());
}

/// Rubs the cubes on each other at a corner, lifts the upper one so fast that all ranks join, and puts it down on the
/// whole lower one before ranks send bonds again. Returns how many ranks were too far from the corner to take part.
int rub_lift_and_put_down(const Vector3& corner) {
  TwoCubes shared(MPI_COMM_WORLD, rough(), 7), alone(MPI_COMM_SELF, rough(), 7);
  const auto compute = [&](const Vector3& shift, const Vector3& velocity) {
    for (TwoCubes* cubes : {&shared, &alone}) {
      cubes->compute({Vector3::Zero(), shift}, {Vector3::Zero(), velocity});
    }
  };
  for (int step = 0; step < 4; ++step) {
    compute(corner - Vector3(0, 0, 0.03), Vector3(0.5, 0, 0));
  }
  EXPECT_LT(alone.force_on(1).x(), -1e-5);  // friction, by bonds
  int far = shared.contacts().owned_near().empty() ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &far, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  compute(corner + Vector3(0, 0, 0.01), Vector3(0, 0, 60));
  EXPECT_EQ(alone.force_on(1), Vector3::Zero());
  compute(Vector3(0.01, 0.01, -0.03), Vector3::Zero());
  EXPECT_GT(alone.force_on(1).z(), 1.0);
  EXPECT_EQ(shared.forces(), alone.forces());
  EXPECT_EQ(shared.energy(), alone.energy());
  return far;
}

TEST(Contacts, ARankThatJoinsClearsBondsInTheSameStepAsTheirOwners) {
  int far = 0;
  for (const double x : {-0.95, 0.95}) {
    for (const double y : {-0.95, 0.95}) {
      far += rub_lift_and_put_down({x, y, 0});
    }
  }
  EXPECT_EQ(far > 0, parallel::size_of(MPI_COMM_WORLD) > 1);
}

TEST(Contacts, AnImpactKeepsMomentumAndEnergyAndExchangesVelocities) {
  TwoCubes cubes(MPI_COMM_WORLD);
  std::array<Vector3, 2> shift = {Vector3::Zero(), Vector3::Zero()};
  std::array<Vector3, 2> velocity = {Vector3(0, 0, 0.5), Vector3(0, 0, -1)};  // m/s; 1 kg each
  double most_energy = 0.0, largest_error = 0.0;
  bool touched = false;
  for (int step = 0; step < 400; ++step) {
    cubes.compute(shift, velocity, BondUpdate::stretch);
    const Vector3 on_lower = cubes.force_on(0), on_upper = cubes.force_on(1);
    ASSERT_LT((on_lower + on_upper).norm(), 1e-12 * (1 + on_upper.norm()));
    touched = touched || on_upper.z() > 1.0;
    // Velocities at half steps: the energy now is that of the mean of two of them.
    const Vector3 lower = velocity[0] + dt / 2 * on_lower, upper = velocity[1] + dt / 2 * on_upper;
    const double energy = (lower.squaredNorm() + upper.squaredNorm()) / 2 + cubes.energy();
    most_energy = std::max(most_energy, cubes.energy());
    largest_error = std::max(largest_error, std::abs(energy - 0.625));
    velocity[0] += dt * on_lower;
    velocity[1] += dt * on_upper;
    shift[0] += dt * velocity[0];
    shift[1] += dt * velocity[1];
  }
  ASSERT_TRUE(touched);
  EXPECT_NEAR(most_energy, 0.5625, 0.03);  // all of the relative motion's, mu v^2/2, for a moment
  EXPECT_LT(largest_error, 2e-3);          // of second order in the step
  EXPECT_NEAR(velocity[0].z() + velocity[1].z(), -0.5, 1e-12);
  EXPECT_NEAR(velocity[0].z(), -1.0, 0.01);
  EXPECT_NEAR(velocity[1].z(), 0.5, 0.01);
  EXPECT_EQ(cubes.energy(), 0.0);
}

TEST(Contacts, DampingTakesEnergy) {
  scene::Contact contact;
  contact.damping = 5e-3;
  TwoCubes cubes(MPI_COMM_WORLD, contact);
  double shift = 0.0, velocity = -1.0;  // of the upper cube; the lower one does not move
  for (int step = 0; step < 400; ++step) {
    cubes.compute({Vector3::Zero(), Vector3(0, 0, shift)}, {Vector3::Zero(), Vector3(0, 0, velocity)});
    velocity += dt * cubes.force_on(1).z();
    shift += dt * velocity;
  }
  EXPECT_GT(velocity, 0.3);
  EXPECT_LT(velocity, 0.95);
}

TEST(Contacts, ReportTheirMotionOnOneRank) {
  TwoCubes cubes(MPI_COMM_WORLD, rough());
  for (int step = 0; step < 9; ++step) {  // the means are taken at step 8
    cubes.compute({Vector3::Zero(), Vector3(0, 0, -0.03)}, {Vector3::Zero(), Vector3(0.001, 0, 0)});
  }
  const ContactMotion now = cubes.contacts().now(0);
  int reporting = now.overlap > 0 ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &reporting, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  EXPECT_EQ(reporting, 1);
  if (now.overlap > 0) {
    EXPECT_NEAR(now.overlap, 0.02, 2e-4);  // 0.02 m deep over a square metre
    EXPECT_NEAR(now.normal.z(), -1.0, 1e-3);
    EXPECT_NEAR(now.slip.x(), -0.001, 1e-5);
    EXPECT_NEAR(now.point.z(), 1.0, 0.02);
    EXPECT_NEAR(cubes.contacts().motion(0).overlap / now.overlap, 1.0, 1e-9);
  }
  EXPECT_GT(cubes.contacts().deepest(0), 0.005);
}

void expect_to_go_on_from_the_archive(const scene::Contact& contact) {
  const auto compute = [](TwoCubes& cubes, int step, BondUpdate bonds) {
    cubes.compute({Vector3::Zero(), Vector3(1e-4 * step, 0, -0.03)}, {Vector3::Zero(), Vector3(0.1, 0, 0)}, bonds);
  };
  TwoCubes straight(MPI_COMM_WORLD, contact), stopped(MPI_COMM_WORLD, contact), resumed(MPI_COMM_WORLD, contact);
  support::MemoryArchive archive(MPI_COMM_WORLD);
  for (int step = 0; step < 8; ++step) {
    compute(straight, step, BondUpdate::stretch);
    compute(stopped, step, BondUpdate::stretch);
  }
  stopped.archive(archive);
  archive.restore();
  resumed.archive(archive);
  compute(resumed, 7, BondUpdate::keep);
  EXPECT_EQ(resumed.forces(), straight.forces());
  EXPECT_LT(straight.force_on(1).x(), -1e-6);  // friction, by bonds that are in the archive
  compute(straight, 8, BondUpdate::stretch);
  compute(resumed, 8, BondUpdate::stretch);
  EXPECT_EQ(resumed.forces(), straight.forces());
}

TEST(Contacts, ContinueFromTheirArchiveToTheBit) {
  expect_to_go_on_from_the_archive(rough());
  expect_to_go_on_from_the_archive(rough_with_memory());
}

/// The upper one of two pieces of a body goes down at the side of the lower one, without leaving it.
TEST(Contacts, OfABodyWithItselfReportTheSamePartOnAnyRanksAndAfterARestart) {
  const auto compute = [](TwoCubes& cubes, int step, BondUpdate bonds = BondUpdate::stretch) {
    const Vector3 shift(-0.04 * std::min(step, 24), 0, -0.05 - 0.02 * std::max(step - 24, 0));
    const Vector3 velocity = step < 24 ? Vector3(-40, 0, 0) : Vector3(0, 0, -20);
    cubes.compute({Vector3::Zero(), shift}, {Vector3::Zero(), velocity}, bonds);
  };
  TwoCubes shared(MPI_COMM_WORLD, {}, 2, true), alone(MPI_COMM_SELF, {}, 2, true);
  support::MemoryArchive archive(MPI_COMM_WORLD);
  for (int step = 0; step < 48; ++step) {
    compute(shared, step);
    compute(alone, step);
    ASSERT_GT(shared.reported_force().dot(shared.force_on(1)), 0) << step;  // the upper one's
    ASSERT_EQ(shared.reported_force(), alone.reported_force()) << step;
  }
  EXPECT_LT(shared.reported_force().x(), -0.9 * shared.reported_force().norm());
  shared.archive(archive);
  archive.restore();
  TwoCubes resumed(MPI_COMM_WORLD, {}, 2, true);
  resumed.archive(archive);
  compute(resumed, 47, BondUpdate::keep);
  EXPECT_EQ(resumed.reported_force(), shared.reported_force());
}

TEST(Contacts, DoNotAskForStatesWhileTheSidesAreFar) {
  TwoCubes cubes(MPI_COMM_WORLD);
  EXPECT_TRUE(cubes.contacts().needs_all_states(0));
  cubes.compute({Vector3::Zero(), Vector3(0, 0, 50)}, {Vector3::Zero(), Vector3(0, 0, -1)});
  EXPECT_FALSE(cubes.contacts().needs_all_states(4));
  EXPECT_TRUE(cubes.contacts().needs_all_states(1 << 20));
  EXPECT_TRUE(cubes.contacts().owned_near().empty());
  EXPECT_EQ(cubes.force_on(1), Vector3::Zero());
}

}  // namespace
}  // namespace idiophone::contact
