#pragma once
// What is done before MPI starts.

#include <cstdlib>

namespace idiophone::app {

/// HDF5 uses no shared file pointers, but Open MPI guards them with a semaphore of the whole machine that has the
/// file's name without its folder. A process that is killed at the wrong moment leaves it locked, and each later run
/// that opens a file of that name would wait forever. This choice of another component needs no semaphore. Call it
/// before MPI_Init, or before the first file is opened.
inline void avoid_semaphores_of_files() {
  ::setenv("OMPI_MCA_sharedfp", "individual", 0);
}

}  // namespace idiophone::app
