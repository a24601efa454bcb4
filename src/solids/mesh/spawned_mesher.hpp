#pragma once
// The process of idiophone_gmsh, and the channels to it.

#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <optional>
#include <utility>

namespace idiophone::mesh {

/// An open file or socket, which it closes.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&&) = delete;
  void close() {
    if (number_ >= 0) {
      ::close(std::exchange(number_, -1));
    }
  }
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

/// Two connected descriptors: ours and the process's. A socket: writing to a process that died raises no signal.
struct Channel {
  /// @throws std::runtime_error if the system has none
  Channel() : Channel(make()) {}
  Descriptor ours, its;

 private:
  static std::array<int, 2> make();
  explicit Channel(std::array<int, 2> ends) : ours(ends[0]), its(ends[1]) {}
};

/// What is left of a process that ended.
struct ExitState {
  int status = 0;       ///< of wait()
  double memory = 0.0;  ///< the most that it held, bytes
};

/// idiophone_gmsh. It does not outlive this object.
class SpawnedMesher {
 public:
  /// @throws std::runtime_error when the program is not found, or does not start
  SpawnedMesher();
  ~SpawnedMesher();
  SpawnedMesher(const SpawnedMesher&) = delete;
  SpawnedMesher& operator=(const SpawnedMesher&) = delete;
  SpawnedMesher(SpawnedMesher&&) = delete;
  SpawnedMesher& operator=(SpawnedMesher&&) = delete;

  /// How it ended, if it did.
  [[nodiscard]] std::optional<ExitState> end();

  Channel request, messages, answer;

 private:
  pid_t id_ = 0;
};

}  // namespace idiophone::mesh
