// ping_pong BYTES ...: how long messages of MPI between ranks 0 and 1 take. A line for each size: the size, and half
// the time there and back, s, the median of many.

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace {

constexpr std::size_t rounds = 1000;

/// There and back; both ranks call it.
double round_trip(std::vector<char>& data, int rank) {
  const auto size = static_cast<int>(data.size());
  const auto send = [&] { MPI_Send(data.data(), size, MPI_CHAR, 1 - rank, 0, MPI_COMM_WORLD); };
  const auto receive = [&] { MPI_Recv(data.data(), size, MPI_CHAR, 1 - rank, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE); };
  const double start = MPI_Wtime();
  if (rank == 0) {
    send();
    receive();
  } else {
    receive();
    send();
  }
  return MPI_Wtime() - start;
}

}  // namespace

int main(int count, char** words) {
  MPI_Init(&count, &words);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  for (int i = 1; i < count; ++i) {
    std::vector<char> data(std::stoul(words[i]));
    std::array<double, rounds> times{};
    std::ranges::generate(times, [&] { return round_trip(data, rank) / 2; });
    std::ranges::nth_element(times, times.begin() + rounds / 2);
    if (rank == 0) {
      std::cout << data.size() << ' ' << times[rounds / 2] << std::endl;
    }
  }
  MPI_Finalize();
}
