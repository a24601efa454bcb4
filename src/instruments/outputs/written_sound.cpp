#include "idiophone/instruments/outputs/written_sound.hpp"

#include <fmt/format.h>

#include <utility>

#include "idiophone/run/results/result_file.hpp"

namespace idiophone::outputs {

WavOutput::WavOutput(std::filesystem::path file, loop::WavSettings settings, std::int64_t samples)
    : Collected(samples), file_(std::move(file)), settings_(std::move(settings)) {
  loop::require_room_for_wav(file_, static_cast<double>(samples) * settings_.channels);
}

void WavOutput::finish() {
  loop::write_wav(file_, take(), settings_);
}

ResultOutput::ResultOutput(std::filesystem::path file, Origin origin, std::string unit, int rate, std::int64_t samples,
                           std::function<void(results::ResultFile&)> more)
    : Collected(samples),
      file_(std::move(file)),
      origin_(std::move(origin)),
      unit_(std::move(unit)),
      rate_(rate),
      more_(std::move(more)) {
  loop::require_folder_of(file_);
}

void ResultOutput::finish() {
  const std::vector<double> sound = take();
  std::vector<std::string> columns;
  for (std::size_t channel = 0; channel < channels(); ++channel) {
    columns.push_back(fmt::format("channel_{}", channel + 1));
  }
  auto result = results::ResultFile::create(file_, origin_, MPI_COMM_SELF);
  const spectra::Series series{.path = "/audio/" + origin_.name,
                               .unit = unit_,
                               .rate = static_cast<double>(rate_),
                               .columns = columns,
                               .description = "sound of bodies that were played",
                               .positions = {}};
  result.declare(series);
  result.append(series.path, sound);
  if (more_) {
    more_(result);
  }
  result.flush();
}

}  // namespace idiophone::outputs
