#include "together.hpp"

#include <string>

#include "checks.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/foundation/parallel/reduce.hpp"
#include "load_mesh_file.hpp"

namespace idiophone::mesh {

void check_together(MPI_Comm communicator, const std::function<void()>& check) {
  std::string problem;
  try {
    check();
  } catch (const deck::DeckError& error) {
    problem = error.what();
  }
  // No rank waits elsewhere, so this may take as long as the slowest one reads.
  const int ranks = parallel::size_of(communicator);
  const int first = parallel::smallest(problem.empty() ? ranks : parallel::rank_of(communicator), communicator);
  if (first == ranks) {
    return;
  }
  parallel::broadcast(problem, communicator, first);
  parallel::on_root(communicator, [&] { throw deck::DeckError({}, problem); });
}

void read_together(const scene::Body& body, MPI_Comm communicator, const std::function<void()>& read) {
  check_together(communicator, [&] { read_within_limit(body, read); });
}

void require_fit(const scene::Body& body, const std::string& problem, MPI_Comm communicator) {
  check_together(communicator, [&] {
    if (!problem.empty()) {
      throw deck::DeckError(body.mesh_where, text_of_problem(body, problem));
    }
  });
}

}  // namespace idiophone::mesh
