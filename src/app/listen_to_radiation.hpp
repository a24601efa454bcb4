#pragma once
// `idiophone radiate --listeners`: a result of `radiate` at other listeners.

#include <mpi.h>

#include <filesystem>
#include <string>
#include <vector>

#include "shared_options.hpp"

namespace idiophone::app {

struct ListenToRadiation {
  std::filesystem::path result;        ///< NAME_radiation.h5
  std::filesystem::path listeners;     ///< a deck as that of `idiophone listen`
  std::vector<std::string> overrides;  ///< of this deck
  std::filesystem::path output;        ///< folder of the new result
  Style style = Style::text;
};

/// Computes the pressures from the solutions of a result, and writes a new one. Collective.
/// @throws std::runtime_error or deck::DeckError if the result or the deck can't be read, the deck has another floor
///         than the result, a listener is inside a body, or the new result would replace the old one
void listen_to_radiation(const ListenToRadiation& options, MPI_Comm communicator);

}  // namespace idiophone::app
