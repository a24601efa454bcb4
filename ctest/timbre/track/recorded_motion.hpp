#pragma once
// The result of a run, with channels that are known.

#include "idiophone/run/results/result_file.hpp"
#include "temporary_file.hpp"

namespace idiophone::timbre {

/// A result with the velocity of a ball, (t, 2 t, 2 t) m/s, and two knocks, 100 rows a second for a second: 3 N in the
/// rows 10 and 11, with a row of 1 N after them, and 8 N in row 50.
class RecordedMotion {
 public:
  RecordedMotion() : file_("motion.h5") {
    auto result = results::ResultFile::create(
        file_.path(), {.name = "ball", .code_version = "0", .deck_text = "name: ball\n", .overrides = {}},
        MPI_COMM_WORLD);
    const std::vector<std::string> axes = {"x", "y", "z"};
    result.declare({"/motion/ball/velocity", "m/s", 100.0, axes, "velocity", {}});
    result.declare({"/contacts/knock/force", "N", 100.0, axes, "force", {}});
    result.declare({"/motion/ball/nothing", "1", 100.0, {"value"}, "no rows", {}});
    std::vector<double> velocity, force(300);
    for (int row = 0; row < 100; ++row) {
      const double time = row / 100.0;
      velocity.insert(velocity.end(), {time, 2.0 * time, 2.0 * time});
    }
    force[30] = force[34] = 3.0;  // row 10 along x, row 11 along y
    force[36] = 1.0;
    force[152] = -8.0;
    result.append("/motion/ball/velocity", velocity);
    result.append("/contacts/knock/force", force);
    result.flush();
  }
  [[nodiscard]] const std::filesystem::path& path() const { return file_.path(); }

 private:
  support::TemporaryFile file_;
};

}  // namespace idiophone::timbre
