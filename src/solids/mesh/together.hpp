#pragma once
// Errors of mesh files that ranks read together: one for all of them, which points into the deck.

#include <mpi.h>

#include <functional>
#include <string>

#include "idiophone/scene/body.hpp"

namespace idiophone::mesh {

/// Calls `check()` on every rank. It makes no collective call. Collective.
/// @throws deck::DeckError on rank 0 and parallel::RemoteFailure elsewhere, if it throws a deck::DeckError on any rank:
///         what the lowest of them says
void check_together(MPI_Comm communicator, const std::function<void()>& check);

/// Calls `read()` on every rank, within the limit for reading the body's file. It makes no collective call. Collective.
/// @throws as check_together(), pointing at the body's mesh key and naming the file, if it throws a
///         std::runtime_error on any rank
void read_together(const scene::Body& body, MPI_Comm communicator, const std::function<void()>& read);

/// Collective.
/// @param problem  of this rank, for text_of_problem(); empty for none
/// @throws as check_together(), pointing at the body's mesh key
void require_fit(const scene::Body& body, const std::string& problem, MPI_Comm communicator);

}  // namespace idiophone::mesh
