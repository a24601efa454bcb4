#include "idiophone/app/guest.hpp"

#include <slepcsys.h>

#include <mutex>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/parallel/broadcast.hpp"
#include "idiophone/foundation/parallel/errors.hpp"
#include "idiophone/run/loop/facts.hpp"
#include "idiophone/run/loop/stop.hpp"
#include "program_start.hpp"

namespace idiophone::app {

namespace {

bool has_started_mpi = false;
bool has_started_petsc = false;

void start_mpi() {
  if (mpi_runs()) {
    return;
  }
  int level = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_MULTIPLE, &level);
  has_started_mpi = true;
}

/// Every rank by itself, so that a part of the ranks can compute, too.
void start_petsc() {
  PetscBool runs = PETSC_FALSE;
  SlepcInitialized(&runs);
  if (runs == PETSC_TRUE) {
    return;
  }
  PetscInitialized(&runs);
  if (runs == PETSC_FALSE) {
    PETSC_COMM_WORLD = MPI_COMM_SELF;
    PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");  // the signals are the host's
  }
  if (SlepcInitialize(nullptr, nullptr, nullptr, nullptr) != 0) {
    throw FailedComputation("PETSc can't be started");
  }
  has_started_petsc = true;
}

/// PETSc's errors become exceptions while this object lives.
class PetscErrors {
 public:
  PetscErrors() { PetscPushErrorHandler(PetscReturnErrorHandler, nullptr); }
  PetscErrors(const PetscErrors&) = delete;
  PetscErrors& operator=(const PetscErrors&) = delete;
  PetscErrors(PetscErrors&&) = delete;
  PetscErrors& operator=(PetscErrors&&) = delete;
  ~PetscErrors() { PetscPopErrorHandler(); }
};

/// A duplicate of a communicator: our messages do not mix with the host's.
class Duplicate {
 public:
  explicit Duplicate(MPI_Comm original) { MPI_Comm_dup(original, &own_); }
  Duplicate(const Duplicate&) = delete;
  Duplicate& operator=(const Duplicate&) = delete;
  Duplicate(Duplicate&&) = delete;
  Duplicate& operator=(Duplicate&&) = delete;
  ~Duplicate() { MPI_Comm_free(&own_); }
  [[nodiscard]] MPI_Comm get() const { return own_; }

 private:
  MPI_Comm own_ = MPI_COMM_NULL;
};

}  // namespace

bool mpi_runs() {
  int is_started = 0, is_ended = 0;
  MPI_Initialized(&is_started);
  MPI_Finalized(&is_ended);
  return is_started != 0 && is_ended == 0;
}

void compute_as_guest(const std::function<MPI_Comm()>& communicator, const std::function<int(MPI_Comm)>& work) {
  static std::mutex one_at_a_time;
  const std::lock_guard guard(one_at_a_time);
  avoid_semaphores_of_files();
  start_mpi();
  start_petsc();
  const PetscErrors errors;
  const Duplicate own(communicator());
  const loop::GuestSignals signals;
  int status = loop::exit_finished;
  bool is_deck_wrong = false;
  try {
    parallel::collectively(own.get(), [&] {
      try {
        loop::require_one_instruction_set(loop::instruction_set(), own.get());
        status = work(own.get());
      } catch (const deck::DeckError&) {
        is_deck_wrong = true;
        throw;
      }
    });
  } catch (const std::exception& error) {
    parallel::broadcast(is_deck_wrong, own.get());  // all ranks are here
    if (is_deck_wrong) {
      throw WrongDeck(error.what());
    }
    throw FailedComputation(error.what());
  }
  if (status == loop::exit_resumable) {
    throw StoppedRun(loop::GuestSignals::take());
  }
}

void end_guest() {
  if (has_started_petsc && mpi_runs()) {
    SlepcFinalize();
  }
  if (has_started_mpi && mpi_runs()) {
    MPI_Finalize();
  }
}

}  // namespace idiophone::app
