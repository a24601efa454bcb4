#include "idiophone/run/record/sound.hpp"

namespace idiophone::record {

void declare_sound(const propagation::AudioPath& audio_path, results::ResultFile& result) {
  for (const scene::Listener& listener : audio_path.listeners()) {
    spectra::Series series{
        "/audio/" + listener.name,     audio_path.unit(), audio_path.rate(), {}, audio_path.description(), {},
        listener.attached.value_or("")};
    for (const scene::Receiver& receiver : listener.receivers) {
      series.columns.push_back(receiver.channel);
      series.positions.push_back({receiver.position[0], receiver.position[1], receiver.position[2]});
    }
    result.declare(series);
  }
  for (const scene::ReferenceSet& reference : audio_path.references()) {
    result.add_reference(reference.name, reference.frequencies);
  }
}

void write_sound(propagation::AudioPath& audio_path, std::int64_t most, results::ResultFile& result) {
  const std::vector<std::vector<double>> sounds = audio_path.take(most);
  for (std::size_t l = 0; l < sounds.size(); ++l) {
    result.append("/audio/" + audio_path.listeners()[l].name, sounds[l]);
  }
}

}  // namespace idiophone::record
