#pragma once
// A sound file for a test.

#include <sndfile.h>

#include <string>
#include <vector>

#include "temporary_file.hpp"

namespace idiophone::support {

/// A file with channels of one length. It goes with this object.
class TemporarySound {
 public:
  /// @param channels  [channels][samples]
  /// @param format    of libsndfile
  TemporarySound(int rate, const std::vector<std::vector<double>>& channels,
                 int format = SF_FORMAT_WAV | SF_FORMAT_FLOAT)
      : file_("sound") {
    SF_INFO info = {};
    info.samplerate = rate;
    info.channels = static_cast<int>(channels.size());
    info.format = format;
    std::vector<double> frames;
    for (std::size_t i = 0; i < channels.front().size(); ++i) {
      for (const std::vector<double>& channel : channels) {
        frames.push_back(channel[i]);
      }
    }
    SNDFILE* file = sf_open(path().c_str(), SFM_WRITE, &info);
    sf_writef_double(file, frames.data(), static_cast<sf_count_t>(channels.front().size()));
    sf_close(file);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return file_.path(); }

 private:
  TemporaryFile file_;
};

}  // namespace idiophone::support
