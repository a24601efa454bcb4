#include "idiophone/run/results/sound_reader.hpp"

#include "idiophone/files/attributes.hpp"
#include "idiophone/files/format.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/reading.hpp"
#include "idiophone/run/results/series_reader.hpp"

namespace idiophone::results {

namespace {

const std::string audio = "/audio/";

spectra::Sound read_sound(const SeriesReader& reader, const spectra::Series& series) {
  spectra::Sound sound{.name = series.path.substr(audio.size()),
                       .rate = series.rate,
                       .unit = series.unit,
                       .channels = series.columns,
                       .samples = {},
                       .attached = series.attached};
  reader.require_intact(series);
  const std::vector<double> values = reader.read(series);
  const auto channels = sound.channels.size();
  sound.samples.assign(channels, std::vector<double>(values.size() / channels));
  for (std::size_t i = 0; i < values.size(); ++i) {
    sound.samples[i % channels][i / channels] = values[i];
  }
  return sound;
}

}  // namespace

std::vector<spectra::Sound> read_sounds(const std::filesystem::path& result) {
  const SeriesReader reader(result);
  std::vector<spectra::Sound> sounds;
  for (const spectra::Series& series : reader.all()) {
    if (series.path.starts_with(audio)) {
      sounds.push_back(read_sound(reader, series));
    }
  }
  return sounds;
}

std::vector<ReferenceFrequencies> read_references(const std::filesystem::path& result) {
  return files::read_within_limit(result, [&] {
    const auto file = hdf5::open_for_reading(result);
    files::check_format(file.id(), files::result_format, result);
    std::vector<ReferenceFrequencies> references;
    for (const auto& path : hdf5::datasets_below(file.id(), "/references")) {
      const auto dataset = hdf5::open_dataset(file.id(), path);
      references.push_back({.name = hdf5::text_of(dataset.id(), "name"),
                            .frequencies = hdf5::read<double>(dataset.id(), hdf5::whole(dataset.id()))});
    }
    return references;
  });
}

}  // namespace idiophone::results
