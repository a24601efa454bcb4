#include "idiophone/study/mode_pictures/mode_pictures.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace idiophone::mode_pictures {

namespace {

constexpr double width = 280.0, height = 220.0, title_height = 24.0, margin = 14.0;  // of a picture, px
constexpr std::size_t columns = 4;

/// From space to a picture.
class View {
 public:
  explicit View(std::span<const Vector3> nodes) {
    Eigen::AlignedBox2d box;
    Eigen::AlignedBox3d space;
    for (const Vector3& node : nodes) {
      box.extend(flat(node));
      space.extend(node);
    }
    const Eigen::Vector2d sizes = box.sizes().cwiseMax(1e-12);
    scale_ = std::min((width - 2.0 * margin) / sizes[0], (height - title_height - 2.0 * margin) / sizes[1]);
    middle_ = box.center();
    size_ = space.diagonal().norm();
  }

  /// Towards the eye.
  [[nodiscard]] static Vector3 eye() { return Vector3(0.45, -0.7, 0.6).normalized(); }

  /// px, from the upper left corner of a picture.
  [[nodiscard]] Eigen::Vector2d at(const Vector3& place) const {
    const Eigen::Vector2d way = scale_ * (flat(place) - middle_);
    return {0.5 * width + way[0], title_height + 0.5 * (height - title_height) - way[1]};
  }

  /// The diagonal of the body's box, m.
  [[nodiscard]] double size() const { return size_; }

 private:
  static Eigen::Vector2d flat(const Vector3& place) {
    const Vector3 right = Vector3::UnitZ().cross(eye()).normalized();
    return {right.dot(place), eye().cross(right).dot(place)};
  }

  double scale_ = 1.0;  // px/m
  double size_ = 0.0;
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();
};

/// A triangle that is seen.
struct Visible {
  std::size_t triangle = 0;
  double depth = 0.0;    ///< towards the eye
  double outward = 0.0;  ///< its displacement along its normal, over the largest displacement
  double light = 1.0;
};

std::string colour_of(const Visible& seen) {
  const double strength = std::clamp(std::abs(seen.outward), 0.0, 1.0);
  const auto level = [&](double full) {
    return static_cast<int>(std::lround(255.0 * seen.light * (1.0 - strength * (1.0 - full))));
  };
  return seen.outward > 0.0 ? fmt::format("#{:02x}{:02x}{:02x}", level(0.85), level(0.15), level(0.1))
                            : fmt::format("#{:02x}{:02x}{:02x}", level(0.1), level(0.3), level(0.85));
}

void add_picture(std::string& svg, const Surface& surface, const View& view, const std::vector<double>& shape) {
  constexpr double stretch = 0.06;  // largest displacement over the size of the body
  const Eigen::Map<const Eigen::Matrix3Xd> ways(shape.data(), 3, static_cast<Eigen::Index>(surface.nodes.size()));
  const double largest = std::max(ways.colwise().norm().maxCoeff(), 1e-300);
  const auto moved = [&](Index node) {
    return Vector3(surface.nodes[node] + stretch * view.size() / largest * ways.col(node));
  };
  std::vector<Visible> all;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [i, j, k] = surface.triangles[t];
    const Vector3 a = moved(i), b = moved(j), c = moved(k);
    const Vector3 normal = (b - a).cross(c - a).normalized();
    if (const double facing = normal.dot(View::eye()); facing > 0.0) {
      const Vector3 way = (ways.col(i) + ways.col(j) + ways.col(k)) / 3.0;
      all.push_back({.triangle = t,
                     .depth = View::eye().dot(a + b + c),
                     .outward = way.dot(normal) / largest,
                     .light = 0.75 + 0.25 * facing});
    }
  }
  std::ranges::stable_sort(all, {}, &Visible::depth);
  for (const Visible& seen : all) {
    const std::string colour = colour_of(seen);
    svg += "<path d=\"";
    char step = 'M';
    for (const Index node : surface.triangles[seen.triangle]) {
      const Eigen::Vector2d place = view.at(moved(node));
      svg += fmt::format("{}{:.1f} {:.1f}", step, place[0], place[1]);
      step = 'L';
    }
    svg += fmt::format("Z\" fill=\"{0}\" stroke=\"{0}\"/>\n", colour);
  }
}

}  // namespace

void require_drawable(std::size_t triangles) {
  if (triangles > most_triangles) {
    throw std::runtime_error(
        fmt::format("pictures are possible of surfaces with up to {} triangles, this one has {}: choose a coarser mesh",
                    most_triangles, triangles));
  }
}

std::string svg_of_modes(const Surface& surface, const std::vector<std::vector<double>>& shapes,
                         const std::vector<std::string>& titles) {
  require_drawable(surface.triangles.size());
  const View view(surface.nodes);
  const std::size_t rows = (shapes.size() + columns - 1) / columns;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      width * static_cast<double>(std::min(columns, shapes.size())), height * static_cast<double>(rows));
  for (std::size_t mode = 0; mode < shapes.size(); ++mode) {
    svg += fmt::format("<g transform=\"translate({} {})\" stroke-width=\"0.3\">\n",
                       width * static_cast<double>(mode % columns), height * static_cast<double>(mode / columns));
    svg += fmt::format(
        "<text x=\"{}\" y=\"16\" text-anchor=\"middle\" font-family=\"sans-serif\" font-size=\"13\">{}</text>\n",
        0.5 * width, titles[mode]);
    add_picture(svg, surface, view, shapes[mode]);
    svg += "</g>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace idiophone::mode_pictures
