#include "idiophone/run/bodies/read_run_deck.hpp"

#include "idiophone/air/propagation/ears.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/run/bodies/recorded_source.hpp"

namespace idiophone::bodies {

scene::Scene read_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                       MPI_Comm communicator) {
  // Rank 0 answers for the deck; the others read it only once it is known to be right.
  scene::Scene scene;
  parallel::on_root(communicator, [&] {
    scene = scene::read_deck(deck, overrides);
    propagation::check_heads(scene);
    bodies::check_recordings(scene);
  });
  return parallel::is_root(communicator) ? scene : scene::read_deck(deck, overrides);
}

}  // namespace idiophone::bodies
