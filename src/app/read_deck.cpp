#include "read_deck.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

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

std::size_t find_body(const scene::Scene& scene, const std::string& name) {
  std::vector<std::string> names;
  std::ranges::transform(scene.bodies, std::back_inserter(names), &scene::Body::name);
  const auto chosen = name.empty() ? names.begin() : std::ranges::find(names, name);
  if (chosen == names.end()) {
    throw std::runtime_error(
        fmt::format("there is no body '{}' in the deck; it has: {}", name, fmt::join(names, ", ")));
  }
  return chosen - names.begin();
}

}  // namespace idiophone::app
