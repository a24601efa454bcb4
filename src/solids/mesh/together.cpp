#include "together.hpp"

#include <stdexcept>

#include "checks.hpp"
#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "load_mesh_file.hpp"

namespace idiophone::mesh {

void check_together(MPI_Comm communicator, const std::function<void()>& check) {
  std::string problem, first;
  try {
    check();
  } catch (const deck::DeckError& error) {
    problem = error.what();
  }
  try {
    parallel::agree(communicator, problem);
  } catch (const std::runtime_error& error) {
    first = error.what();
  }
  parallel::on_root(communicator, [&] {
    if (!first.empty()) {
      throw deck::DeckError({}, first);
    }
  });
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
