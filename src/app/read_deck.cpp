#include "read_deck.hpp"

#include "idiophone/hearing/ears.hpp"
#include "idiophone/parallel/errors.hpp"
#include "idiophone/source/recorded_source.hpp"

namespace idiophone::app {

scene::Scene read_deck(const std::filesystem::path& deck, const std::vector<std::string>& overrides,
                       MPI_Comm communicator) {
  // Rank 0 answers for the deck; the others read it only once it is known to be right.
  scene::Scene scene;
  parallel::on_root(communicator, [&] {
    scene = scene::read_deck(deck, overrides);
    hearing::check_heads(scene);
    source::check_recordings(scene);
  });
  return parallel::is_root(communicator) ? scene : scene::read_deck(deck, overrides);
}

}  // namespace idiophone::app
