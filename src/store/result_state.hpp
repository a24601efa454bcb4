#pragma once
// The state of a ResultFile.

#include "idiophone/store/result_file.hpp"
#include "shared_file.hpp"

namespace idiophone::store {

struct ResultFile::State : SharedFile {
  bool new_pictures = false;  ///< frames or modes, which the .xdmf does not show yet

  /// Appends one body's part of a frame.
  void append_frame(const BodyFrame& frame);
};

}  // namespace idiophone::store
