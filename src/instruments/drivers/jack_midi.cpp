#ifdef IDIOPHONE_HAS_JACK
#include <jack/jack.h>
#include <jack/midiport.h>
#endif

#include <atomic>
#include <stdexcept>

#include "idiophone/instruments/drivers/midi.hpp"
#include "idiophone/instruments/outputs/quiet_audio.hpp"
#include "idiophone/instruments/outputs/ring.hpp"

namespace idiophone::drivers {

#ifdef IDIOPHONE_HAS_JACK

struct JackMidi::Client {
  jack_client_t* jack = nullptr;
  jack_port_t* port = nullptr;
  outputs::Ring<MidiMessage> messages{1024};
  std::atomic<std::size_t> lost{0};

  /// In a thread of JACK, which must not wait.
  static int process(jack_nframes_t frames, void* self) {
    auto& client = *static_cast<Client*>(self);
    void* buffer = jack_port_get_buffer(client.port, frames);
    jack_midi_event_t event{};
    for (jack_nframes_t i = 0; i < jack_midi_get_event_count(buffer); ++i) {
      if (jack_midi_event_get(&event, buffer, i) != 0) {
        continue;
      }
      if (std::optional<MidiMessage> message = midi_message({event.buffer, event.size})) {
        client.lost += client.messages.put(*message) ? 0 : 1;
      }
    }
    return 0;
  }
};

JackMidi::JackMidi() : client_(std::make_unique<Client>()) {
  outputs::silence_audio_libraries();
  jack_status_t status{};
  client_->jack = jack_client_open("idiophone", JackNoStartServer, &status);
  if (client_->jack == nullptr) {
    throw std::runtime_error("MIDI: there is no JACK server; start one, e.g. `jackd -d alsa`");
  }
  client_->port = jack_port_register(client_->jack, "midi", JACK_DEFAULT_MIDI_TYPE, JackPortIsInput, 0);
  jack_set_process_callback(client_->jack, &Client::process, client_.get());
  if (client_->port == nullptr || jack_activate(client_->jack) != 0) {
    jack_client_close(client_->jack);
    throw std::runtime_error("MIDI: the JACK server refuses a MIDI input");
  }
}

JackMidi::~JackMidi() {
  jack_client_close(client_->jack);
}

bool JackMidi::take(MidiMessage& message) {
  return client_->messages.take(message);
}

std::size_t JackMidi::lost() const {
  return client_->lost;
}

#else

struct JackMidi::Client {};

JackMidi::JackMidi() {
  throw std::runtime_error(
      "MIDI: this program was built without JACK; install its development files and build again, or read a MIDI file");
}

JackMidi::~JackMidi() = default;

bool JackMidi::take(MidiMessage& /*message*/) {
  return false;
}

std::size_t JackMidi::lost() const {
  return 0;
}

#endif

}  // namespace idiophone::drivers
