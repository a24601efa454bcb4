#pragma once
// A recorded motion whose triangles change over time, as a motion of triangles that stay.
//
// Each segment of time has triangles of its own. Segments with even and odd numbers take turns in two banks of
// triangles, each with three vertices of its own. While a bank waits, each of its triangles is a point, which moves
// with the present triangle that is nearest to it. So it has no area and hides nothing. It has the pressure of that
// triangle, so that filters and visibility go on where the triangles change. After a change, "nearest" is meant of
// where the triangle was, so that its sound can fade out (surface::Emitter), then of where it will be.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "idiophone/files/hdf5.hpp"
#include "idiophone/files/hdf5_dataset.hpp"
#include "idiophone/run/results/surface_motion_reader.hpp"

namespace idiophone::results {

/// Not thread-safe: it keeps what it found for the segment that it read last.
class SegmentedMotion {
 public:
  /// Whether a file has segments.
  [[nodiscard]] static bool is_in(hid_t file);

  /// @param file       must outlive this object
  /// @param path       for messages
  /// @param fade_rows  of the sound of old triangles after a change
  /// @throws std::runtime_error, naming what is wrong, if a segment is missing or contradicts itself
  SegmentedMotion(hid_t file, std::filesystem::path path, std::int64_t fade_rows);

  [[nodiscard]] std::int64_t rows() const { return segments_.back().end; }
  [[nodiscard]] std::int64_t triangles() const { return bank_size_[0] + bank_size_[1]; }
  [[nodiscard]] std::int64_t vertices() const { return 3 * triangles(); }
  /// Vertex numbers of the triangles [begin, begin + count).
  [[nodiscard]] static std::vector<std::array<std::int32_t, 3>> triangles_of(std::int64_t begin, std::int64_t count);

  // As SurfaceMotionReader has them. @throws std::runtime_error if the file can't be read

  [[nodiscard]] std::int64_t stage_at(std::int64_t row) const;
  [[nodiscard]] std::vector<SurfaceMotionReader::Surface> surfaces_at(std::int64_t row) const;
  /// Positions where each triangle is used first.
  [[nodiscard]] std::vector<double> read_reference(std::int64_t begin, std::int64_t count) const;
  [[nodiscard]] std::vector<double> read_pressure(std::int64_t row, std::int64_t rows, std::int64_t begin,
                                                  std::int64_t count) const;
  [[nodiscard]] std::vector<double> read_position(std::int64_t row, std::int64_t rows, std::int64_t begin,
                                                  std::int64_t count) const;

 private:
  struct Segment {
    hdf5::Identifier pressure, position;
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::int64_t begin = 0, end = 0;  ///< rows of the recording
  };
  using Table = hdf5::Identifier Segment::*;

  [[nodiscard]] Segment open_segment(std::size_t number, std::int64_t begin, const std::set<std::string>& tables) const;
  [[nodiscard]] std::int64_t first_of(std::size_t segment) const { return segment % 2 == 0 ? 0 : bank_size_[0]; }
  /// The segment's number of a triangle, or -1 if the segment does not use it.
  [[nodiscard]] std::int64_t number_in(std::size_t segment, std::int64_t triangle) const;
  [[nodiscard]] std::size_t segment_at(std::int64_t row) const;
  /// The segment before or after it whose triangles wait; none if there is none.
  [[nodiscard]] std::optional<std::size_t> waiting_at(std::int64_t row) const;
  /// Calls visit(row, its values) for each row.
  template <class Visitor>
  void visit_rows(std::int64_t row, std::int64_t rows, Table table, const Visitor& visit) const;
  /// The corners of a segment's triangles.
  [[nodiscard]] std::vector<std::array<Vector3, 3>> surface_of(std::size_t segment, std::int64_t row) const;
  [[nodiscard]] std::vector<Vector3> centres_of(std::size_t segment, std::int64_t row) const;

  /// A triangle that waits.
  struct Follower {
    std::int64_t number = -1;          ///< of the triangle of the present segment that it moves with; -1: of none
    Vector3 offset = Vector3::Zero();  ///< from that one's centre, m
  };
  /// [triangles]
  [[nodiscard]] const std::vector<Follower>& followers(std::int64_t row) const;
  [[nodiscard]] std::vector<Follower> find_followers(std::int64_t row) const;

  hid_t file_;
  std::filesystem::path path_;
  std::int64_t fade_rows_;
  std::vector<Segment> segments_;
  std::array<std::int64_t, 2> bank_size_ = {};  ///< triangles
  mutable std::int64_t known_stage_ = -1;
  mutable std::vector<Follower> followers_;  ///< of the known stage
};

}  // namespace idiophone::results
