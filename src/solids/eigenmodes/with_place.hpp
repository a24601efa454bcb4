#pragma once
// Places in the deck for errors of solvers, which do not know them.

#include <stdexcept>

#include "idiophone/foundation/deck/location.hpp"

namespace idiophone::eigenmodes {

/// What work() returns.
/// @throws deck::DeckError at `where` for a std::runtime_error of the work; a deck::DeckError of the work as it is
template <class Work>
auto with_place(const deck::Location& where, const Work& work) {
  try {
    return work();
  } catch (const deck::DeckError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw deck::DeckError(where, error.what());
  }
}

}  // namespace idiophone::eigenmodes
