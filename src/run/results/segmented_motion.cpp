#include "segmented_motion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "idiophone/files/hdf5_group.hpp"
#include "idiophone/files/reading.hpp"
#include "nearest_point.hpp"
#include "surface_motion_paths.hpp"

namespace idiophone::results {

namespace {

constexpr std::int64_t values_at_once = 1 << 21;

std::string table_of(std::size_t segment, const std::string& name) {
  return fmt::format("{}/{}{}", surface_motion::segments, segment, name);
}

/// Opens a table of a segment that has this shape; 0 stands for any number of rows or columns.
hdf5::Identifier open_part(hid_t file, const std::set<std::string>& tables, const std::string& name,
                           const hdf5::Dimensions& shape, const std::filesystem::path& path) {
  if (!tables.contains(name)) {
    throw std::runtime_error(
        fmt::format("{}: there is no {}; segments are numbered from 0 without a gap, and each has triangles, pressure "
                    "and position",
                    path.string(), name));
  }
  auto table = hdf5::open_dataset(file, name);
  const hdf5::Dimensions found = hdf5::shape_of(table.id());
  const auto fits = [](hsize_t size, hsize_t wanted) { return size > 0 && (wanted == 0 || size == wanted); };
  if (!std::ranges::equal(found, shape, fits)) {
    throw std::runtime_error(fmt::format("{}: {} has the shape [{}], expected [{}] (0: any number above 0)",
                                         path.string(), name, fmt::join(found, " x "), fmt::join(shape, " x ")));
  }
  return table;
}

std::size_t segment_count(const std::set<std::string>& tables) {
  return static_cast<std::size_t>(
      std::ranges::count_if(tables, [](const std::string& name) { return name.ends_with(surface_motion::triangles); }));
}

Vector3 vertex_of(std::span<const double> positions, std::int32_t vertex) {
  return Vector3::Map(&positions[3UL * static_cast<std::size_t>(vertex)]);
}

std::array<Vector3, 3> corners_of(std::span<const double> positions, const std::array<std::int32_t, 3>& triangle) {
  return {vertex_of(positions, triangle[0]), vertex_of(positions, triangle[1]), vertex_of(positions, triangle[2])};
}

Vector3 centre_of(const std::array<Vector3, 3>& corners) {
  return (corners[0] + corners[1] + corners[2]) / 3.0;
}

}  // namespace

bool SegmentedMotion::is_in(hid_t file) {
  return !hdf5::datasets_below(file, surface_motion::segments).empty();
}

SegmentedMotion::SegmentedMotion(hid_t file, std::filesystem::path path, std::int64_t fade_rows)
    : file_(file), path_(std::move(path)), fade_rows_(fade_rows) {
  const std::vector<std::string> names = hdf5::datasets_below(file, surface_motion::segments);
  const std::set<std::string> tables(names.begin(), names.end());
  const std::size_t count = std::max<std::size_t>(1, segment_count(tables));
  for (std::size_t number = 0; number < count; ++number) {
    segments_.push_back(open_segment(number, number == 0 ? 0 : rows(), tables));
    std::int64_t& size = bank_size_[number % 2];
    size = std::max(size, static_cast<std::int64_t>(segments_.back().triangles.size()));
  }
}

SegmentedMotion::Segment SegmentedMotion::open_segment(std::size_t number, std::int64_t begin,
                                                       const std::set<std::string>& tables) const {
  Segment segment;
  const auto open = [&](const std::string& name, const hdf5::Dimensions& shape) {
    return open_part(file_, tables, table_of(number, name), shape, path_);
  };
  const auto triangles = open(surface_motion::triangles, {0, 3});
  segment.position = open(surface_motion::position, {0, 0, 3});
  const hdf5::Dimensions positions = hdf5::shape_of(segment.position.id());
  segment.pressure = open(surface_motion::pressure, {positions[0], hdf5::shape_of(triangles.id())[0]});
  segment.begin = begin;
  segment.end = begin + static_cast<std::int64_t>(positions[0]);
  const auto corners = hdf5::read<std::int32_t>(triangles.id(), hdf5::whole(triangles.id()));
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    segment.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    for (const std::int32_t corner : segment.triangles.back()) {
      if (corner < 0 || static_cast<hsize_t>(corner) >= positions[1]) {
        throw std::runtime_error(fmt::format("{}: triangle {} of segment {} has vertex {}; there are {}",
                                             path_.string(), i / 3, number, corner, positions[1]));
      }
    }
  }
  return segment;
}

std::vector<std::array<std::int32_t, 3>> SegmentedMotion::triangles_of(std::int64_t begin, std::int64_t count) {
  std::vector<std::array<std::int32_t, 3>> triangles;
  for (std::int64_t number = begin; number < begin + count; ++number) {
    const auto first = static_cast<std::int32_t>(3 * number);
    triangles.push_back({first, first + 1, first + 2});
  }
  return triangles;
}

std::size_t SegmentedMotion::segment_at(std::int64_t row) const {
  return static_cast<std::size_t>(std::ranges::upper_bound(segments_, row, {}, &Segment::end) - segments_.begin());
}

std::optional<std::size_t> SegmentedMotion::waiting_at(std::int64_t row) const {
  const std::size_t present = segment_at(row);
  const auto& [pressure, position, triangles, begin, end] = segments_[present];
  const bool fading = present > 0 && row - begin < std::min(fade_rows_, (end - begin) / 2);
  if (present + 1 < segments_.size() && !fading) {
    return present + 1;
  }
  return present > 0 ? std::optional(present - 1) : std::nullopt;
}

std::int64_t SegmentedMotion::stage_at(std::int64_t row) const {
  const auto present = static_cast<std::int64_t>(segment_at(row));
  return 2 * present + (waiting_at(row) > segment_at(row) ? 1 : 0);
}

std::int64_t SegmentedMotion::number_in(std::size_t segment, std::int64_t triangle) const {
  const std::int64_t number = triangle - first_of(segment);
  const bool is_used = number >= 0 && number < static_cast<std::int64_t>(segments_[segment].triangles.size());
  return is_used ? number : -1;
}

template <class Visitor>
void SegmentedMotion::visit_rows(std::int64_t row, std::int64_t rows, Table table, const Visitor& visit) const {
  const std::int64_t end = row + rows;
  while (row < end) {
    const Segment& segment = segments_[segment_at(row)];
    hdf5::Hyperslab box = hdf5::whole((segment.*table).id());
    box.begin[0] = static_cast<hsize_t>(row - segment.begin);
    box.size[0] = 1;
    const auto width = static_cast<std::int64_t>(hdf5::volume(box.size));
    const std::int64_t count = std::clamp<std::int64_t>(values_at_once / width, 1, std::min(end, segment.end) - row);
    box.size[0] = static_cast<hsize_t>(count);
    const std::vector<double> values =
        files::read_naming(path_, [&] { return hdf5::read<double>((segment.*table).id(), box); });
    for (std::int64_t i = 0; i < count; ++i) {
      visit(row + i, std::span(values).subspan(static_cast<std::size_t>(i * width), static_cast<std::size_t>(width)));
    }
    row += count;
  }
}

std::vector<std::array<Vector3, 3>> SegmentedMotion::surface_of(std::size_t segment, std::int64_t row) const {
  std::vector<std::array<Vector3, 3>> surface;
  visit_rows(row, 1, &Segment::position, [&](std::int64_t, std::span<const double> positions) {
    for (const auto& triangle : segments_[segment].triangles) {
      surface.push_back(corners_of(positions, triangle));
    }
  });
  return surface;
}

std::vector<SurfaceMotionReader::Surface> SegmentedMotion::surfaces_at(std::int64_t row) const {
  std::vector<SurfaceMotionReader::Surface> surfaces;
  const auto add = [&](std::size_t segment) {
    surfaces.push_back({first_of(segment), surface_of(segment, segments_[segment].begin)});
  };
  add(segment_at(row));
  if (const auto waiting = waiting_at(row)) {
    add(*waiting);
  }
  return surfaces;
}

std::vector<Vector3> SegmentedMotion::centres_of(std::size_t segment, std::int64_t row) const {
  std::vector<Vector3> centres;
  std::ranges::transform(surface_of(segment, row), std::back_inserter(centres), centre_of);
  return centres;
}

const std::vector<SegmentedMotion::Follower>& SegmentedMotion::followers(std::int64_t row) const {
  if (known_stage_ != stage_at(row)) {
    followers_ = find_followers(row);
    known_stage_ = stage_at(row);
  }
  return followers_;
}

std::vector<SegmentedMotion::Follower> SegmentedMotion::find_followers(std::int64_t row) const {
  std::vector<Follower> all(static_cast<std::size_t>(triangles()));
  const auto waiting = waiting_at(row);
  if (!waiting) {
    return all;
  }
  const std::size_t present = segment_at(row);
  const bool was_heard = *waiting < present;
  const auto& [pressure, position, triangles, begin, end] = segments_[*waiting];
  const std::int64_t last = was_heard ? end - 1 : begin;  // row of the waiting segment that is next to the change
  const std::int64_t before_last = std::clamp(was_heard ? last - 1 : last + 1, begin, end - 1);
  const std::int64_t here = was_heard ? last + 1 : last - 1;  // of the present segment, likewise
  const std::vector<Vector3> present_centres = centres_of(present, here);
  const NearestPoint nearest(present_centres);
  const std::vector<Vector3> centres = centres_of(*waiting, last);
  const std::vector<Vector3> centres_before = centres_of(*waiting, before_last);
  Follower* follower = &all[static_cast<std::size_t>(first_of(*waiting))];
  for (std::size_t i = 0; i < centres.size(); ++i, ++follower) {
    const Vector3 centre_here = 2.0 * centres[i] - centres_before[i];
    follower->number = nearest.to(centre_here);
    if (follower->number >= 0) {
      follower->offset = centre_here - present_centres[static_cast<std::size_t>(follower->number)];
    }
  }
  return all;
}

std::vector<double> SegmentedMotion::read_pressure(std::int64_t row, std::int64_t rows, std::int64_t begin,
                                                   std::int64_t count) const {
  std::vector<double> values;
  visit_rows(row, rows, &Segment::pressure, [&](std::int64_t now, std::span<const double> pressures) {
    const std::size_t segment = segment_at(now);
    for (std::int64_t triangle = begin; triangle < begin + count; ++triangle) {
      const std::int64_t own = number_in(segment, triangle);
      const std::int64_t number = own >= 0 ? own : followers(now)[static_cast<std::size_t>(triangle)].number;
      values.push_back(number >= 0 ? pressures[static_cast<std::size_t>(number)] : 0.0);
    }
  });
  return values;
}

std::vector<double> SegmentedMotion::read_position(std::int64_t row, std::int64_t rows, std::int64_t begin,
                                                   std::int64_t count) const {
  std::vector<double> values;
  visit_rows(row, rows, &Segment::position, [&](std::int64_t now, std::span<const double> positions) {
    const std::size_t segment = segment_at(now);
    const auto corners = [&](std::int64_t number) {
      return corners_of(positions, segments_[segment].triangles[static_cast<std::size_t>(number)]);
    };
    for (std::int64_t vertex = begin; vertex < begin + count; ++vertex) {
      Vector3 place;
      if (const std::int64_t own = number_in(segment, vertex / 3); own >= 0) {
        place = corners(own).at(vertex % 3);
      } else {
        const Follower& follower = followers(now)[static_cast<std::size_t>(vertex / 3)];
        place = centre_of(corners(std::max<std::int64_t>(follower.number, 0))) + follower.offset;
      }
      values.insert(values.end(), place.begin(), place.end());
    }
  });
  return values;
}

std::vector<double> SegmentedMotion::read_reference(std::int64_t begin, std::int64_t count) const {
  std::vector<double> values(3 * static_cast<std::size_t>(count), 0.0);
  std::vector<bool> is_known(static_cast<std::size_t>(count), false);
  const auto all_known = [&] { return std::ranges::all_of(is_known, std::identity()); };
  for (std::size_t segment = 0; segment < segments_.size() && !all_known(); ++segment) {
    const std::vector<double> positions = read_position(segments_[segment].begin, 1, begin, count);
    for (std::size_t i = 0; i < is_known.size(); ++i) {
      if (!is_known[i] && number_in(segment, (begin + static_cast<std::int64_t>(i)) / 3) >= 0) {
        is_known[i] = true;
        std::copy_n(&positions[3 * i], 3, &values[3 * i]);
      }
    }
  }
  return values;
}

}  // namespace idiophone::results
