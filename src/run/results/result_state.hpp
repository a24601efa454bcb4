#pragma once
// The state of a ResultFile.

#include "idiophone/files/shared_file.hpp"
#include "idiophone/run/results/result_file.hpp"

namespace idiophone::results {

struct ResultFile::State : files::SharedFile {
  bool new_pictures = false;  ///< frames or modes, which the .xdmf does not show yet

  /// Appends one body's part of a frame.
  void append_frame(const BodyFrame& frame);
};

}  // namespace idiophone::results
