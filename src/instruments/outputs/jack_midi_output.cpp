#ifdef IDIOPHONE_HAS_JACK
#include <jack/jack.h>
#include <jack/midiport.h>
#endif

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>

#include "idiophone/instruments/outputs/midi_output.hpp"
#include "idiophone/instruments/outputs/quiet_audio.hpp"

namespace idiophone::outputs {

#ifdef IDIOPHONE_HAS_JACK

namespace {

using namespace std::chrono_literals;

/// A client of JACK with one MIDI output.
class JackMidiOutput {
 public:
  explicit JackMidiOutput(std::vector<MidiMessage> messages) : messages_(std::move(messages)) {
    silence_audio_libraries();
    jack_status_t status{};
    jack_.reset(jack_client_open("idiophone", JackNoStartServer, &status));
    if (!jack_) {
      throw std::runtime_error("MIDI: there is no JACK server; start one, e.g. `jackd -d alsa`");
    }
    port_ = jack_port_register(jack_.get(), "music", JACK_DEFAULT_MIDI_TYPE, JackPortIsOutput, 0);
    rate_ = jack_get_sample_rate(jack_.get());
    jack_set_process_callback(jack_.get(), &JackMidiOutput::process, this);
    jack_on_shutdown(
        jack_.get(), [](void* self) { static_cast<JackMidiOutput*>(self)->is_gone_ = true; }, this);
    if (port_ == nullptr || jack_activate(jack_.get()) != 0) {
      throw std::runtime_error("MIDI: the JACK server refuses a MIDI output");
    }
  }

  void connect(const std::string& destination) {
    const std::unique_ptr<const char*, void (*)(const char**)> inputs(
        jack_get_ports(jack_.get(), nullptr, JACK_DEFAULT_MIDI_TYPE, JackPortIsInput),
        [](const char** names) { jack_free(static_cast<void*>(names)); });
    std::string known;
    for (const char** name = inputs.get(); name != nullptr && *name != nullptr; ++name) {
      if (std::string(*name).find(destination) != std::string::npos) {
        if (jack_connect(jack_.get(), jack_port_name(port_), *name) != 0) {
          throw std::runtime_error(fmt::format("MIDI: the JACK server can't connect to {}", *name));
        }
        return;
      }
      known += (known.empty() ? "" : ", ") + std::string(*name);
    }
    throw std::runtime_error(fmt::format("MIDI: JACK has no MIDI input whose name contains '{}'; there are: {}",
                                         destination, known.empty() ? "none" : known));
  }

  [[nodiscard]] bool is_connected() const { return jack_port_connected(port_) > 0; }
  [[nodiscard]] bool is_over() const { return state_ == State::over; }
  void start() { change(State::waits, State::plays); }
  /// All notes end in the next period.
  void end() { change(State::plays, State::ends); }

  void require_server() const {
    if (is_gone_) {
      throw std::runtime_error("MIDI: the JACK server stopped");
    }
  }

 private:
  enum class State { waits, plays, ends, over };
  struct Close {
    void operator()(jack_client_t* client) const { jack_client_close(client); }
  };

  /// The thread of JACK may have gone on to a later state.
  void change(State from, State to) { state_.compare_exchange_strong(from, to); }

  /// In a thread of JACK, which must not wait.
  static int process(jack_nframes_t frames, void* self) {
    auto& output = *static_cast<JackMidiOutput*>(self);
    void* buffer = jack_port_get_buffer(output.port_, frames);
    jack_midi_clear_buffer(buffer);
    if (output.state_ == State::plays) {
      output.send(buffer, frames);
    } else if (output.state_ == State::ends) {
      send_silence(buffer);
      output.state_ = State::over;
    }
    return 0;
  }

  void send(void* buffer, jack_nframes_t frames) {
    for (; next_ < messages_.size(); ++next_) {
      const MidiMessage& message = messages_[next_];
      const std::int64_t due = std::llround(message.time * rate_);
      if (due >= now_ + frames) {
        break;
      }
      const auto offset = static_cast<jack_nframes_t>(std::max<std::int64_t>(due - now_, 0));
      if (jack_midi_event_write(buffer, offset, message.bytes.data(), message.count) != 0) {
        break;  // the buffer is full: in the next period
      }
    }
    now_ += frames;
    if (next_ == messages_.size()) {
      change(State::plays, State::ends);
    }
  }

  static void send_silence(void* buffer) {
    constexpr int controller = 0xb0, all_notes_off = 123, channels = 16;
    for (int channel = 0; channel < channels; ++channel) {
      const std::array<unsigned char, 3> bytes{static_cast<unsigned char>(controller | channel), all_notes_off, 0};
      jack_midi_event_write(buffer, 0, bytes.data(), bytes.size());
    }
  }

  std::vector<MidiMessage> messages_;
  std::size_t next_ = 0;
  std::int64_t now_ = 0;  // audio samples since the start
  double rate_ = 0.0;     // of the server, Hz
  std::atomic<State> state_{State::waits};
  std::atomic<bool> is_gone_{false};
  jack_port_t* port_ = nullptr;
  std::unique_ptr<jack_client_t, Close> jack_;  // last: it is closed before the rest goes
};

}  // namespace

void play_midi(std::vector<MidiMessage> messages, const std::string& destination, const std::function<bool()>& stop) {
  constexpr auto settling = 200ms;  // the server connects some periods later, and what is sent before is lost
  JackMidiOutput output(std::move(messages));
  const auto wait_for = [&](const auto& condition) {
    while (!condition() && !stop()) {
      output.require_server();
      std::this_thread::sleep_for(10ms);
    }
  };
  if (destination.empty()) {
    spdlog::info("the music waits until something is connected to idiophone:music; Ctrl-C ends it");
    wait_for([&] { return output.is_connected(); });
  } else {
    output.connect(destination);
  }
  std::this_thread::sleep_for(settling);
  output.start();
  wait_for([&] { return output.is_over(); });
  output.end();
  for (int tries = 0; tries < 50 && !output.is_over(); ++tries) {
    std::this_thread::sleep_for(10ms);
  }
}

#else

void play_midi(std::vector<MidiMessage> /*messages*/, const std::string& /*destination*/,
               const std::function<bool()>& /*stop*/) {
  throw std::runtime_error("MIDI: this program was built without JACK; install its development files and build again");
}

#endif

}  // namespace idiophone::outputs
