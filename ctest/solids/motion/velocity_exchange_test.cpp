// Velocities of ghosts between any number of ranks, through shared memory and by messages.

#include "velocity_exchange.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <thread>

#include "block_mesh.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/solids/motion/ghost_exchange.hpp"
#include "message_exchange.hpp"
#include "ranks.hpp"
#include "shared_exchange.hpp"

namespace idiophone::motion {
namespace {

class VelocityExchangeTest : public testing::Test {
 protected:
  VelocityExchangeTest() : part(mesh::distribute({block}, MPI_COMM_WORLD)), state(part.node_ids.size()) {}

  /// Another one for each node and step.
  [[nodiscard]] double velocity(std::size_t node, int step) const { return part.node_ids[node] + 0.001 * step; }

  void send(VelocityExchange& exchange, int step) {
    for (Index node = 0; node < part.owned_nodes; ++node) {
      std::ranges::fill(state[node].velocity, velocity(node, step));
    }
    exchange.send(state);
  }

  void expect_velocities_of_owners(VelocityExchange& exchange) {
    for (int step = 0; step < 1000; ++step) {
      send(exchange, step);
      exchange.receive(state);
      for (std::size_t node = part.owned_nodes; node < state.size(); ++node) {
        ASSERT_EQ(state[node].velocity[2], velocity(node, step));
      }
    }
  }

  mesh::Mesh block = support::block_mesh(element::tet4, {0.4, 0.1, 0.1}, {8, 2, 2});
  mesh::Part part;
  std::vector<solid::NodeState> state;
};

ON_RANKS(1, 3);

TEST_F(VelocityExchangeTest, GhostsHaveTheVelocitiesOfTheirOwnersThroughSharedMemory) {
  SharedExchange exchange(part, MPI_COMM_WORLD);
  expect_velocities_of_owners(exchange);
}

TEST_F(VelocityExchangeTest, GhostsHaveTheVelocitiesOfTheirOwnersByMessages) {
  const parallel::Handle<PetscSF> forest = ghost_exchange(part, MPI_COMM_WORLD);
  MessageExchange exchange(part, forest);
  expect_velocities_of_owners(exchange);
}

TEST_F(VelocityExchangeTest, ARankThatWaitsLongLeavesItsProcessorToOthers) {
  SharedExchange exchange(part, MPI_COMM_WORLD);
  constexpr auto late = std::chrono::milliseconds(200);
  MPI_Barrier(MPI_COMM_WORLD);
  const std::clock_t before = std::clock();
  if (parallel::is_root(MPI_COMM_WORLD)) {
    std::this_thread::sleep_for(late);
  }
  send(exchange, 1);
  exchange.receive(state);
  EXPECT_LT(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC, 0.05);  // s of processor time
}

}  // namespace
}  // namespace idiophone::motion
