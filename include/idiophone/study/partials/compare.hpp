#pragma once
// Comparison of partials with reference frequencies.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idiophone/study/partials/partials.hpp"

namespace idiophone::partials {

/// Frequencies that a sound is expected to have.
struct References {
  std::string name;                 ///< e.g. "thin plate (Leissa)"
  std::vector<double> frequencies;  ///< Hz
};

/// A reference and the partial nearest to it.
struct Match {
  double reference = 0.0;              ///< Hz
  std::optional<std::size_t> partial;  ///< index into the partials; none if no partial is within the tolerance
  double cents = 0.0;                  ///< partial over reference, 1200 log2 of their ratio; 0 if there is none
  double percent = 0.0;                ///< the same in percent of the reference
};

/// 1200 log2(frequency/reference): a semitone is 100 cents, 1 % is about 17.
[[nodiscard]] double cents(double frequency, double reference);

/// Finds the nearest partial (in cents) to each reference. Two references may share a partial, as degenerate
/// modes do.
/// @param tolerance  cents; a partial farther away is no match
/// @return [references.frequencies], in their order
/// @throws std::invalid_argument if a reference or the tolerance is not positive
[[nodiscard]] std::vector<Match> match(std::span<const Partial> partials, const References& references,
                                       double tolerance = 100.0);

/// Cents from the nearest reference to a frequency (Hz); none if it is farther away than the tolerance (cents).
[[nodiscard]] std::optional<double> cents_from_nearest(double frequency, const References& references,
                                                       double tolerance);

/// What the samples are, and so which levels a table has.
enum class SampleUnit { any, pascal };

/// Sound pressure level of a partial, dB re 20 uPa: of the root mean square of a sine of its amplitude.
/// @param level  of the amplitude, dB re 1 Pa
[[nodiscard]] double sound_pressure_level(double level);

/// The partials as text, one per line: frequency, level, sound pressure level if the unit is Pa, decay time, and for
/// each set of references a column with the cents from the nearest one within the tolerance. A partial that leaves a
/// remainder has a note. Then the references without a partial.
/// @throws std::invalid_argument as match()
[[nodiscard]] std::string table(std::span<const Partial> partials, std::span<const References> sets = {},
                                double tolerance = 100.0, SampleUnit unit = SampleUnit::any);

/// A cell of a column of cents, or a dash, right-aligned under the name of the references.
[[nodiscard]] std::string cents_cell(std::optional<double> cents, const References& references);
/// The head of that column.
[[nodiscard]] std::string cents_head(const References& references);

}  // namespace idiophone::partials
