#pragma once
// Bodies and the air, which act on each other (docs/method/waves.md, "The air acts on the bodies").

#include <mpi.h>

#include <vector>

#include "idiophone/air/propagation/air_load.hpp"
#include "idiophone/run/bodies/preparation.hpp"
#include "idiophone/solids/motion/motion.hpp"
#include "idiophone/solids/motion/surface_load.hpp"

namespace idiophone::bodies {

class AirCoupling {
 public:
  /// Collective.
  /// @param motion  in which the air acts from now on; must outlive this object, as must `ready` and `air`. A whole
  ///                number of its steps make a step of the air
  AirCoupling(const Preparation& ready, motion::Motion& motion, propagation::AirLoad& air, MPI_Comm communicator);
  AirCoupling(const AirCoupling&) = delete;
  AirCoupling& operator=(const AirCoupling&) = delete;
  AirCoupling(AirCoupling&&) = delete;
  AirCoupling& operator=(AirCoupling&&) = delete;
  ~AirCoupling() = default;

  /// When the motion has begun.
  void start() { load_.start(motion_.state()); }

  /// To be called after each step of the motion. Advances the air where one of its steps ends.
  void after_step();

  /// After the motion's. Collective.
  void archive(parallel::Archive& archive);

 private:
  motion::Motion& motion_;
  propagation::AirLoad& air_;
  int interval_;  // steps of the motion in one of the air
  motion::SurfaceLoad load_;
  parallel::Rows rows_;          // of the archive
  std::vector<double> changes_;  // [triangles x 3 corners] m/s
};

}  // namespace idiophone::bodies
