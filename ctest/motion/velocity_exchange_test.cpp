// Velocities of ghosts between any number of ranks, through shared memory and by messages.

#include "velocity_exchange.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <thread>

#include "block_mesh.hpp"
#include "idiophone/motion/ghost_exchange.hpp"
#include "idiophone/parallel/communicator.hpp"
#include "message_exchange.hpp"
#include "shared_exchange.hpp"

namespace idiophone::motion {
namespace {

constexpr bool is_shared = true;

class VelocityExchangeTest : public testing::TestWithParam<bool> {
 protected:
  VelocityExchangeTest() : part(mesh::distribute({block}, MPI_COMM_WORLD)), state(part.node_ids.size()) {
    if (GetParam() == is_shared) {
      exchange = std::make_unique<SharedExchange>(part, MPI_COMM_WORLD);
    } else {
      exchange = std::make_unique<MessageExchange>(part, forest);
    }
  }

  /// Another one for each node and step.
  [[nodiscard]] double velocity(std::size_t node, int step) const { return part.node_ids[node] + 0.001 * step; }

  void send(int step) {
    for (Index node = 0; node < part.owned_nodes; ++node) {
      std::ranges::fill(state[node].velocity, velocity(node, step));
    }
    exchange->send(state);
  }

  mesh::Mesh block = support::block_mesh(element::tet4, {0.4, 0.1, 0.1}, {8, 2, 2});
  mesh::Part part;
  parallel::Handle<PetscSF> forest = ghost_exchange(part, MPI_COMM_WORLD);
  std::vector<solid::NodeState> state;
  std::unique_ptr<VelocityExchange> exchange;
};

TEST_P(VelocityExchangeTest, GhostsHaveTheVelocitiesOfTheirOwners) {
  for (int step = 0; step < 1000; ++step) {
    send(step);
    exchange->receive(state);
    for (std::size_t node = part.owned_nodes; node < state.size(); ++node) {
      ASSERT_EQ(state[node].velocity[2], velocity(node, step));
    }
  }
}

double processor_time() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

TEST_P(VelocityExchangeTest, ThroughSharedMemoryARankThatWaitsLongLeavesItsProcessorToOthers) {
  if (GetParam() != is_shared) {
    GTEST_SKIP();  // how to wait for messages is up to MPI
  }
  constexpr auto late = std::chrono::milliseconds(200);
  MPI_Barrier(MPI_COMM_WORLD);
  const double before = processor_time();
  if (parallel::is_root(MPI_COMM_WORLD)) {
    std::this_thread::sleep_for(late);
  }
  send(1);
  exchange->receive(state);
  EXPECT_LT(processor_time() - before, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Ways, VelocityExchangeTest, testing::Values(is_shared, !is_shared));

}  // namespace
}  // namespace idiophone::motion
