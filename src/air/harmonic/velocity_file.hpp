#pragma once
// Files of velocities as users write them (docs/use/radiate.md#velocities).

#include <filesystem>
#include <vector>

#include "idiophone/air/harmonic/boundary_elements.hpp"
#include "idiophone/foundation/deck/mistakes.hpp"

namespace idiophone::harmonic {

/// The motion of one point at one frequency.
struct VelocityRow {
  deck::Location where;                            ///< in the file
  double frequency = 0.0;                          ///< Hz
  Vector3 place = Vector3::Zero();                 ///< m
  ComplexVector velocity = ComplexVector::Zero();  ///< m/s
};

/// Rows of a CSV file. Reports what is no such table.
[[nodiscard]] std::vector<VelocityRow> csv_velocities(const std::filesystem::path& file, deck::Mistakes& mistakes);

/// Entries of /velocity of an HDF5 file; the line and column of each are the numbers of its frequency and point, from 1
/// on. Reports values that are not finite, and units that are not SI.
/// @throws std::runtime_error where the file can't be read, or a dataset is missing or does not fit the others
[[nodiscard]] std::vector<VelocityRow> hdf5_velocities(const std::filesystem::path& file, deck::Mistakes& mistakes);

}  // namespace idiophone::harmonic
