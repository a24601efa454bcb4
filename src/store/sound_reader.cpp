#include "idiophone/store/sound_reader.hpp"

#include "attributes.hpp"
#include "format.hpp"
#include "hdf5.hpp"
#include "reading_limit.hpp"
#include "table_checksums.hpp"

namespace idiophone::store {

namespace {

hdf5::Handle open_result(const std::filesystem::path& path) {
  auto file = hdf5::open_for_reading(path);
  check_format(file.id(), result_format, path);
  return file;
}

Sound read_sound(hid_t file, const std::string& path) {
  const auto table = hdf5::open_dataset(file, path);
  Sound sound{.name = path.substr(std::string("/audio/").size()),
              .rate = hdf5::number_of(table.id(), "rate"),
              .unit = hdf5::text_of(table.id(), "unit"),
              .channels = hdf5::texts_of(table.id(), "columns"),
              .samples = {}};
  require_intact_table(file, path, table.id());
  const auto box = hdf5::whole(table.id());
  const auto rows = hdf5::read<double>(table.id(), box);
  const auto channels = sound.channels.size();
  sound.samples.assign(channels, std::vector<double>(box.size.at(0)));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    sound.samples[i % channels][i / channels] = rows[i];
  }
  return sound;
}

}  // namespace

std::vector<Sound> read_sounds(const std::filesystem::path& result) {
  const ReadingLimit limit(result);
  const auto file = open_result(result);
  std::vector<Sound> sounds;
  for (const auto& path : hdf5::datasets_below(file.id(), "/audio")) {
    sounds.push_back(read_sound(file.id(), path));
  }
  return sounds;
}

std::vector<ReferenceFrequencies> read_references(const std::filesystem::path& result) {
  const auto file = open_result(result);
  std::vector<ReferenceFrequencies> references;
  for (const auto& path : hdf5::datasets_below(file.id(), "/references")) {
    const auto dataset = hdf5::open_dataset(file.id(), path);
    references.push_back({.name = hdf5::text_of(dataset.id(), "name"),
                          .frequencies = hdf5::read<double>(dataset.id(), hdf5::whole(dataset.id()))});
  }
  return references;
}

}  // namespace idiophone::store
