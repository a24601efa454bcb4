#include "idiophone/instruments/outputs/quiet_audio.hpp"

#include <alsa/asoundlib.h>
#include <jack/jack.h>

namespace idiophone::outputs {

namespace {

void ignore_alsa(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/, const char* /*format*/,
                 ...) {}

}  // namespace

void silence_audio_libraries() {
  snd_lib_error_set_handler(&ignore_alsa);
  jack_set_error_function([](const char*) {});
  jack_set_info_function([](const char*) {});
}

}  // namespace idiophone::outputs
