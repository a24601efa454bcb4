// ping_pong BYTES ...: how long messages of MPI between ranks 0 and 1 take. A line for each size: the size, half the
// time there and back, and the time that a message takes of a rank which computes while it travels, at each end, s, of
// the rank where that is most; medians of many.

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace {

constexpr std::size_t rounds = 501;

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

/// Computes for about so long, s.
void compute(double seconds) {
  constexpr double per_second = 2e8;
  volatile double sum = 0.0;
  for (double i = 0; i < seconds * per_second; ++i) {
    sum = sum + i;
  }
}

/// Of a computation between two other things, s.
template <class Begin, class End>
double time_around(double seconds, const Begin& begin, const End& end) {
  MPI_Barrier(MPI_COMM_WORLD);
  const double start = MPI_Wtime();
  begin();
  compute(seconds);
  end();
  return MPI_Wtime() - start;
}

/// What one message sent and one received add to a computation that is longer than they travel, for each of both, s.
double overhead(std::vector<char>& data, int rank, double travel) {
  const auto size = static_cast<int>(data.size());
  std::vector<char> received(data.size());
  std::array<MPI_Request, 2> requests{};
  const auto begin = [&] {
    MPI_Irecv(received.data(), size, MPI_CHAR, 1 - rank, 1, MPI_COMM_WORLD, &requests[0]);
    MPI_Isend(data.data(), size, MPI_CHAR, 1 - rank, 1, MPI_COMM_WORLD, &requests[1]);
  };
  const double with = time_around(4 * travel, begin, [&] { MPI_Waitall(2, requests.data(), MPI_STATUSES_IGNORE); });
  return (with - time_around(
                     4 * travel, [] {}, [] {})) /
         2;
}

template <class Measure>
double median(const Measure& measure) {
  std::array<double, rounds> times{};
  std::ranges::generate(times, measure);
  std::ranges::nth_element(times, times.begin() + rounds / 2);
  return times[rounds / 2];
}

}  // namespace

int main(int count, char** words) {
  MPI_Init(&count, &words);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  for (int i = 1; i < count; ++i) {
    std::vector<char> data(std::stoul(words[i]));
    const double travel = median([&] { return round_trip(data, rank) / 2; });
    double processor = median([&] { return overhead(data, rank, travel); });
    MPI_Allreduce(MPI_IN_PLACE, &processor, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    if (rank == 0) {
      std::cout << data.size() << ' ' << travel << ' ' << processor << std::endl;
    }
  }
  MPI_Finalize();
}
