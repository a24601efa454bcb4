#pragma once
// Where the bodies of an engine are over time, for films: vibration, motion, and pieces that fly apart.

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "idiophone/instruments/proxies/engine.hpp"

namespace idiophone::voices {

/// A body in the shape in which its mesh is drawn. In a body that can break, no two tetrahedra share a node.
struct FilmedBody {
  std::string name;
  std::vector<Vector3> nodes;                    ///< at rest, m
  std::vector<std::array<Index, 4>> tetrahedra;  ///< node numbers
  bool breaks = false;
};

struct FilmFrame {
  double time = 0.0;                              ///< s
  std::vector<std::vector<double>> displacement;  ///< [bodies][3 x nodes] from the places at rest, m
};

class ProxyFilm {
 public:
  /// @param names              of the bodies of the engine, which has no pieces yet
  /// @param frames_per_second  above 0
  /// @param rate               audio samples per second
  ProxyFilm(const proxies::Engine& engine, const std::vector<std::string>& names, double frames_per_second, int rate);

  /// Audio samples from one on until a frame is due; 0: now.
  [[nodiscard]] std::int64_t samples_until_frame(std::int64_t sample) const;

  /// Adds a frame. A piece that is not computed stays where it was when it came off.
  /// @param roots  [bodies of the engine] for each, also for pieces, the body that it is or was a part of
  /// @param pose   from the coordinates of a body of the engine to where it is now
  void add(const proxies::Engine& engine, std::span<const std::size_t> roots,
           const std::function<Eigen::Isometry3d(std::size_t body)>& pose);

  [[nodiscard]] const std::vector<FilmedBody>& bodies() const { return bodies_; }
  [[nodiscard]] const std::vector<FilmFrame>& frames() const { return frames_; }

 private:
  [[nodiscard]] std::int64_t next_sample() const;  ///< of the next frame

  double samples_per_frame_;
  int rate_;
  std::vector<FilmedBody> bodies_;
  std::vector<FilmFrame> frames_;
};

}  // namespace idiophone::voices
