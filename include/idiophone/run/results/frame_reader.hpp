#pragma once
// The meshes and frames of a result, without MPI.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace idiophone::results {

/// A body's mesh as it is stored (docs/use/result_file.md).
struct FramedBody {
  std::string name;
  std::vector<double> nodes;        ///< [3 x nodes] undeformed, m
  std::vector<std::int32_t> cells;  ///< [nodes of a cell x cells] node numbers, in VTK's order
  std::size_t cell_nodes = 0;       ///< of a cell: 4, 10 or 8
};

class FrameReader {
 public:
  /// @throws std::runtime_error if the file can't be opened, is damaged or is not a result of idiophone
  explicit FrameReader(const std::filesystem::path& result);
  FrameReader(FrameReader&&) noexcept;
  FrameReader& operator=(FrameReader&&) noexcept;
  FrameReader(const FrameReader&) = delete;
  FrameReader& operator=(const FrameReader&) = delete;
  ~FrameReader();

  /// Times of the frames, s; none if the result has no frames.
  [[nodiscard]] const std::vector<double>& times() const;

  /// Bodies that have frames.
  [[nodiscard]] const std::vector<FramedBody>& bodies() const;

  /// Displacements of a body's nodes in a frame, [3 x nodes] m.
  [[nodiscard]] std::vector<float> displacement(std::size_t body, std::size_t frame) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace idiophone::results
