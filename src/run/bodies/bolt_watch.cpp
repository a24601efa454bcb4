#include "idiophone/run/bodies/bolt_watch.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <span>
#include <string>

#include "idiophone/foundation/parallel/communicator.hpp"
#include "idiophone/run/bodies/observation.hpp"

namespace idiophone::bodies {

namespace {

/// What a preload gives, and a motion takes.
std::string what(const joints::BoltForce& force, const scene::Scene& scene) {
  return force.is_of_shank() ? "the pull of its shank"
                             : fmt::format("the pressure at the joint '{}'", scene.joints[force.joint].name);
}

constexpr const char* without_pull = "head and nut would come off, and here the shank pushes";
constexpr const char* without_pressure = "the parts would come apart there, and here they hold together";

}  // namespace

BoltWatch::BoltWatch(const Preparation& ready, const motion::Motion& motion, MPI_Comm communicator)
    : ready_(ready),
      motion_(motion),
      communicator_(communicator),
      forces_(ready.scene, motion.dynamics().joints(), ready.part, communicator),
      most_taken_(forces_.all().size()) {}

void BoltWatch::note(std::int64_t sample) {
  last_sample_ = sample;
  for (const ReproducibleSum& sum : forces_.taken(motion_.state())) {
    append(words_, sum);
  }
}

void BoltWatch::check() {
  const std::vector<std::int64_t> sums = sum_over_ranks(words_, communicator_);
  words_.clear();
  const std::size_t count = forces_.all().size();
  std::vector<double> taken;
  for (std::span<const std::int64_t> words = sums; !words.empty();) {
    taken.push_back(take_sum(words).value());
  }
  for (std::size_t i = 0; i < taken.size(); ++i) {
    const auto samples_before_last = static_cast<std::int64_t>((taken.size() - 1 - i) / count);
    take(i % count, taken[i], static_cast<double>(last_sample_ - samples_before_last) / ready_.scene.audio.rate);
  }
}

void BoltWatch::take(std::size_t force, double taken, double time) {
  const joints::BoltForce& which = forces_.all()[force];
  if (taken > 1 && has_preload_left(which.bolt)) {
    const scene::Joint& bolt = ready_.scene.joints[which.bolt];
    spdlog::warn(
        "joint {}: at {:.6g} s the motion takes {:.4g} N off {}, which its preload of {:.4g} N gives: {}. Give the "
        "bolt a larger preload, or hit less hard",
        bolt.name, time, taken * bolt.shank->preload, what(which, ready_.scene), bolt.shank->preload,
        which.is_of_shank() ? without_pull : without_pressure);
  }
  most_taken_[force] = std::max(most_taken_[force], taken);
}

bool BoltWatch::has_preload_left(std::size_t bolt) const {
  for (std::size_t force = 0; force < most_taken_.size(); ++force) {
    if (forces_.all()[force].bolt == bolt && most_taken_[force] > 1) {
      return false;
    }
  }
  return true;
}

void BoltWatch::report() const {
  for (std::size_t force = 0; force < most_taken_.size() && parallel::is_root(communicator_); ++force) {
    const joints::BoltForce& which = forces_.all()[force];
    spdlog::info("joint {}: the motion took at most {:.3g} of its preload off {}", ready_.scene.joints[which.bolt].name,
                 most_taken_[force], what(which, ready_.scene));
  }
}

void BoltWatch::archive(parallel::Archive& archive) {
  if (!most_taken_.empty()) {
    archive.root("run/preload_taken", most_taken_);
  }
}

}  // namespace idiophone::bodies
