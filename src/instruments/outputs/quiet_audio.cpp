#include "idiophone/instruments/outputs/quiet_audio.hpp"

#ifdef IDIOPHONE_HAS_ALSA
#include <alsa/asoundlib.h>
#endif
#ifdef IDIOPHONE_HAS_JACK
#include <jack/jack.h>
#endif

namespace idiophone::outputs {

namespace {

#ifdef IDIOPHONE_HAS_ALSA
void ignore_alsa(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/, const char* /*format*/,
                 ...) {}
#endif

}  // namespace

void silence_audio_libraries() {
#ifdef IDIOPHONE_HAS_ALSA
  snd_lib_error_set_handler(&ignore_alsa);
#endif
#ifdef IDIOPHONE_HAS_JACK
  jack_set_error_function([](const char*) {});
  jack_set_info_function([](const char*) {});
#endif
}

}  // namespace idiophone::outputs
