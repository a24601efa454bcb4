#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "idiophone/surface/surface.hpp"

namespace idiophone::surface {

namespace {

void require_length(std::string_view rows, std::size_t length, std::size_t expected) {
  if (length != expected) {
    throw std::invalid_argument(
        fmt::format("surface state: the {} rows hold {} numbers; {} were expected", rows, length, expected));
  }
}

}  // namespace

void Surface::require_between_samples(const char* what) const {
  if (reads_ != 0 || reads_filtered_ != 0) {
    throw std::logic_error(fmt::format("Surface::{}: only between two audio samples, after take()", what));
  }
}

void Surface::save(std::span<double> triangle_rows, std::span<double> vertex_rows) const {
  require_between_samples("save");
  require_length("triangles'", triangle_rows.size(), triangle_state_size() * triangles_);
  require_length("vertices'", vertex_rows.size(), vertex_state_size() * vertices_);
  const std::size_t outputs = pressure_.outputs();
  for (std::size_t number = 0; number < triangles_; ++number) {
    pressure_.save(number, triangle_rows.subspan(number * outputs, outputs));
  }
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    const auto row = vertex_rows.subspan(vertex * vertex_state_size(), vertex_state_size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      displacement_.save(3 * vertex + axis, row.subspan(axis * outputs, outputs));
      row[3 * outputs + axis] = slots_[0][3 * vertex + axis];
    }
  }
}

void Surface::restore(std::span<const double> triangle_rows, std::span<const double> vertex_rows) {
  require_between_samples("restore");
  require_length("triangles'", triangle_rows.size(), triangle_state_size() * triangles_);
  require_length("vertices'", vertex_rows.size(), vertex_state_size() * vertices_);
  const std::size_t outputs = pressure_.outputs();
  for (std::size_t number = 0; number < triangles_; ++number) {
    pressure_.restore(number, triangle_rows.subspan(number * outputs, outputs));
  }
  for (std::size_t vertex = 0; vertex < vertices_; ++vertex) {
    const auto row = vertex_rows.subspan(vertex * vertex_state_size(), vertex_state_size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      displacement_.restore(3 * vertex + axis, row.subspan(axis * outputs, outputs));
      slots_[0][3 * vertex + axis] = row[3 * outputs + axis];
    }
  }
}

}  // namespace idiophone::surface
