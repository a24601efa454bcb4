#include "named_recording.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "idiophone/foundation/deck/location.hpp"
#include "idiophone/foundation/spectra/resampled_sound.hpp"
#include "idiophone/timbre/nodes/read_once.hpp"

namespace idiophone::timbre {

std::shared_ptr<const std::vector<double>> recording_of(const Call& call, std::size_t argument) {
  const std::filesystem::path file = call.folder / call.texts[argument];
  const int rate = call.sound_start.rate;
  try {
    // What is read depends on the rate, and on the version of the file.
    const bool is_there = std::filesystem::is_regular_file(file);
    const auto changed = is_there ? std::filesystem::last_write_time(file).time_since_epoch().count() : 0;
    const auto size = is_there ? std::filesystem::file_size(file) : 0;
    auto samples = read_once<std::vector<double>>(
        file / fmt::format("{} {} {}", rate, changed, size),
        [rate](const std::filesystem::path& version) { return spectra::read_sound_file(version.parent_path(), rate); });
    if (samples->empty()) {
      throw std::runtime_error(call.texts[argument] + " is empty");
    }
    return samples;
  } catch (const std::runtime_error& error) {
    throw deck::DeckError(call.where, error.what());
  }
}

}  // namespace idiophone::timbre
