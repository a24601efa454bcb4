#include <stdexcept>

#include "idiophone/air/surface/surface.hpp"

namespace idiophone::surface {

void Surface::archive(parallel::Archive& archive, const parallel::Rows& triangles, const parallel::Rows& vertices) {
  if (reads_ != 0 || reads_filtered_ != 0) {
    throw std::logic_error("Surface::archive: only between two audio samples, after take()");
  }
  archive.rows("surface/triangles", triangles,
               [this](std::size_t triangle, parallel::ArchiveRow& row) { pressure_.archive(triangle, row); });
  archive.rows("surface/vertices", vertices, [this](std::size_t vertex, parallel::ArchiveRow& row) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      displacement_.archive(3 * vertex + axis, row);
    }
    row.values(std::span(slots_[0]).subspan(3 * vertex, 3));
  });
}

}  // namespace idiophone::surface
