#pragma once
// What happens where the system gives no more memory.

namespace idiophone::app {

/// From here on, an allocation that fails ends the process with a message and the status of a failed run, whoever asked
/// for the memory: C++ code, or a library that crashes because it does not look whether it got any. The launcher then
/// ends the other ranks. Files remain as after kill -9. Call it after MPI_Init, which sets handlers of its own.
void end_without_memory(int rank);

}  // namespace idiophone::app
