#pragma once
// Where the time of a run goes: PETSc's log stages for -log_view, and clocks for the closing table.

#include <petsclog.h>

#include <array>

namespace idiophone::parallel {

enum class Stage { motion, contact, surface, visibility, radiation, store };
inline constexpr std::size_t stage_count = 6;
inline constexpr std::array<const char*, stage_count> stage_names = {"motion",     "contact",   "surface",
                                                                     "visibility", "radiation", "store"};

class Stages {
 public:
  /// Registers the stages with PETSc if its option -log_view is given, since marking them takes time.
  Stages();

  /// Seconds spent in a stage on this rank, where no scope is open.
  [[nodiscard]] double seconds(Stage stage) const { return seconds_[static_cast<std::size_t>(stage)]; }
  [[nodiscard]] double total() const;

  /// Counts seconds that were spent in one stage's scope as another's.
  void move(Stage from, Stage to, double seconds) {
    seconds_[static_cast<std::size_t>(from)] -= seconds;
    seconds_[static_cast<std::size_t>(to)] += seconds;
  }

  /// Lasts as long as a piece of work of one stage. Scopes can nest: the time in the inner one does not count for the
  /// stage of the outer one. All are of one thread. The stages must outlive them, and stay where they are.
  class Scope {
   public:
    Scope(Stages& stages, Stage stage);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Stages& stages_;
    double& seconds_;
    Scope* outer_;
    double start_;
  };

 private:
  std::array<double, stage_count> seconds_ = {};
  Scope* innermost_ = nullptr;
  bool is_logging_ = false;
  std::array<PetscLogStage, stage_count> log_stages_ = {};
};

}  // namespace idiophone::parallel
