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

/// A process that no mpirun or scheduler started is alone. Open MPI would start a daemon for it, which is needed to
/// spawn further processes only, and look for fast networks, which takes a quarter of a second. It would ask hwloc for
/// the machine, which loads the drivers of OpenCL: pocl's has a compiler of 60 MB. Without the daemon, all such
/// processes would have the same temporary folder: one that ends takes it away from one that begins. Nothing in it is
/// needed. Call it before MPI_Init.
inline void start_quickly_if_alone() {
  for (const char* told_by_starter : {"OMPI_COMM_WORLD_SIZE", "PMIX_NAMESPACE", "PMI_RANK"}) {
    if (std::getenv(told_by_starter) != nullptr) {
      return;
    }
  }
  ::setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  ::setenv("OMPI_MCA_orte_create_session_dirs", "false", 0);
  ::setenv("OMPI_MCA_pml", "ob1", 0);
  ::setenv("HWLOC_COMPONENTS", "-opencl", 0);
}

}  // namespace idiophone::app
