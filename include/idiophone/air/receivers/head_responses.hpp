#pragma once
// Head-related impulse responses (HRIR) of a head's two ears, measured for many directions of the source.

#include <cstdint>
#include <filesystem>
#include <memory>

#include "idiophone/air/receivers/filter_bank.hpp"
#include "idiophone/foundation/types.hpp"

struct MYSOFA_EASY;

namespace idiophone::receivers {

/// The responses of a SOFA file (AES69, convention SimpleFreeFieldHRIR), through libmysofa. If they were measured at
/// several distances, the farthest are used. Directions are in the head's frame: x to the front, y to the left, z up.
class HeadResponses {
 public:
  /// Reads the file and resamples its responses to `rate` audio samples a second. They are scaled so that sound from
  /// the front between 200 and 600 Hz, where a head hardly disturbs it, has the mean power at the two ears that it has
  /// at the head's centre without the head. Their delays stay as measured.
  /// @throws std::runtime_error if the file can't be read or is not such a file
  HeadResponses(const std::filesystem::path& file, int rate);

  /// Taps of each response.
  [[nodiscard]] std::size_t taps() const { return taps_; }

  /// Measured directions.
  [[nodiscard]] std::size_t count() const;

  /// Unit vector of a measured direction.
  [[nodiscard]] Vector3 direction(std::int64_t number) const;

  /// Number of the nearest measured direction; the front for a vector of zeros.
  [[nodiscard]] std::int64_t nearest(const Vector3& direction) const;

  /// Of the left and the right ear: [2][taps].
  [[nodiscard]] Responses responses(std::int64_t number) const;

 private:
  [[nodiscard]] double power_of_front() const;

  int rate_;
  std::size_t taps_ = 0;
  double scale_ = 1.0;
  std::unique_ptr<MYSOFA_EASY, void (*)(MYSOFA_EASY*)> file_;
};

}  // namespace idiophone::receivers
