#pragma once
// HDF5 files whose structure is right and whose contents are not: HDF5's own checksums find flipped bytes before our
// readers see them.

#include <filesystem>

#include "mutations.hpp"

namespace idiophone::mutants {

/// Removes, replaces, reshapes or overwrites a few datasets and attributes. Most often also removes the checksums of
/// the program's own, as files of other simulators have none. Does nothing to a file that HDF5 can't open.
void mutate_hdf5(const std::filesystem::path& path, Random& random);

}  // namespace idiophone::mutants
