#include "idiophone/air/radiation/visibility.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "embree.hpp"

namespace idiophone::radiation {

namespace {

constexpr float farthest = 1e9F;  // m

/// A ray, and the triangles that do not block it.
struct Sight {
  embree::Context context;  // first member: Embree passes a pointer to it back
  unsigned body;
  unsigned triangle;  // of the body
  SelfOcclusion self_occlusion;
};

/// Embree's filter: invalidates hits that do not block the ray.
void ignore_own(const RTCFilterFunctionNArguments* hit) {
  const auto& sight = *reinterpret_cast<const Sight*>(hit->context);
  const bool own = RTCHitN_geomID(hit->hit, hit->N, 0) == sight.body;
  if (own &&
      (sight.self_occlusion == SelfOcclusion::excluded || RTCHitN_primID(hit->hit, hit->N, 0) == sight.triangle)) {
    hit->valid[0] = 0;
  }
}

void check_vertices(const Occluders& occluders) {
  const auto vertices = static_cast<Index>(occluders.positions.size() / 3);
  for (std::size_t number = 0; number < occluders.triangles.size(); ++number) {
    for (const Index vertex : occluders.triangles[number]) {
      if (vertex < 0 || vertex >= vertices) {
        throw std::invalid_argument(
            fmt::format("visibility: triangle {} has vertex {}; there are {}", number, vertex, vertices));
      }
    }
  }
}

/// A body must be larger than a point in single precision.
void check_sizes(const Occluders& occluders) {
  for (std::size_t body = 0; body + 1 < occluders.first_triangle.size(); ++body) {
    Eigen::AlignedBox3f box;
    for (Index number = occluders.first_triangle[body]; number < occluders.first_triangle[body + 1]; ++number) {
      for (const Index vertex : occluders.triangles[number]) {
        box.extend(Eigen::Vector3f::Map(&occluders.positions[3UL * vertex]));
      }
    }
    const float distance = box.center().norm();
    if (!(box.sizes().norm() > 1e-5F * distance)) {
      throw std::runtime_error(
          fmt::format("visibility: body number {} is {:.3g} m from the origin, which is too far for its size; move "
                      "everything nearer to the origin, or set radiation.visibility to off",
                      body + 1, distance));
    }
  }
}

}  // namespace

struct Visibility::Bodies {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> first_triangle;
  std::vector<HalfSpace> half_spaces;
  SelfOcclusion self_occlusion;
  std::vector<float> positions;  // and one number more, as Embree reads four at a time
  RTCDevice device;
  RTCScene scene;

  Bodies(const Occluders& occluders, SelfOcclusion self_occlusion_)
      : triangles(occluders.triangles),
        first_triangle(occluders.first_triangle),
        half_spaces(occluders.half_spaces),
        self_occlusion(self_occlusion_),
        positions(occluders.positions),
        device(rtcNewDevice("threads=1")),
        scene(rtcNewScene(device)) {
    positions.push_back(0.0F);
    rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST));
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_LOW);  // a tree for each body, so that each can be refitted
    for (std::size_t body = 0; body + 1 < first_triangle.size(); ++body) {
      add_body(static_cast<unsigned>(body));
    }
    add_obstacles(occluders.obstacles);
    commit();
  }
  ~Bodies() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Bodies(const Bodies&) = delete;
  Bodies& operator=(const Bodies&) = delete;
  Bodies(Bodies&&) = delete;
  Bodies& operator=(Bodies&&) = delete;

  void add_body(unsigned body) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const std::size_t first = first_triangle[body];
    const std::size_t last = first_triangle[body + 1];
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangles.data(),
                               first * sizeof(triangles[0]), sizeof(triangles[0]), last - first);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions.data(), 0,
                               3 * sizeof(float), positions.size() / 3);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_REFIT);
    rtcSetGeometryOccludedFilterFunction(geometry, ignore_own);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, body);
    rtcReleaseGeometry(geometry);
  }

  void add_obstacles(const std::vector<std::array<Vector3, 3>>& obstacles) const {
    if (obstacles.empty()) {
      return;
    }
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const std::size_t corners = 3 * obstacles.size();
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), corners));
    auto* numbers = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(unsigned), obstacles.size()));
    for (std::size_t corner = 0; corner < corners; ++corner) {
      Eigen::Vector3f::Map(vertices + 3 * corner) = obstacles[corner / 3].at(corner % 3).cast<float>();
      numbers[corner] = static_cast<unsigned>(corner);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }

  /// True for points that are not finite.
  bool is_clear(const Vector3& from, const Vector3& to, Sight& sight) const {
    if (!(from.norm() < 2 * farthest && to.norm() < 2 * farthest)) {
      return true;  // not a position
    }
    if (std::ranges::any_of(half_spaces,
                            [&](const HalfSpace& space) { return space.contains(from) || space.contains(to); })) {
      return false;
    }
    embree::initialise(sight.context);
    RTCRay ray{};
    Eigen::Vector3f::Map(&ray.org_x) = from.cast<float>();
    Eigen::Vector3f::Map(&ray.dir_x) = (to - from).cast<float>();
    ray.tfar = 1.0F;
    ray.mask = -1U;
    embree::occlude(scene, ray, sight.context);
    return ray.tfar > 0;  // Embree sets it to minus infinity if the ray is blocked
  }

  void commit() const {
    rtcCommitScene(scene);
    if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE) {
      throw std::runtime_error(fmt::format(
          "visibility: Embree fails with error {} (2: wrong argument, 4: out of memory, 5: unsupported processor); set "
          "radiation.visibility to off to run without it",
          static_cast<int>(error)));
    }
  }
};

Visibility::Visibility(const Occluders& occluders, SelfOcclusion self_occlusion) {
  check_vertices(occluders);
  check_sizes(occluders);
  bodies_ = std::make_unique<Bodies>(occluders, self_occlusion);
}

Visibility::~Visibility() = default;

std::span<float> Visibility::positions() {
  return std::span(bodies_->positions).first(bodies_->positions.size() - 1);
}

void Visibility::move() {
  if (!std::ranges::all_of(positions(), [](float x) { return std::abs(x) < farthest; })) {
    return;  // Embree would stop the program
  }
  for (std::size_t body = 0; body + 1 < bodies_->first_triangle.size(); ++body) {
    RTCGeometry geometry = rtcGetGeometry(bodies_->scene, static_cast<unsigned>(body));
    rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry);
  }
  bodies_->commit();
}

std::array<Vector3, 3> Visibility::corners(Index triangle) const {
  std::array<Vector3, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index vertex = bodies_->triangles[triangle].at(i);
    corners.at(i) = Eigen::Vector3f::Map(&bodies_->positions[3UL * vertex]).cast<double>();
  }
  return corners;
}

TriangleView Visibility::view() const {
  return {bodies_->triangles, bodies_->positions};
}

std::span<const Index> Visibility::first_triangle() const {
  return bodies_->first_triangle;
}

Vector3 Visibility::centre(Index triangle) const {
  const auto [a, b, c] = corners(triangle);
  return (a + b + c) / 3;
}

bool Visibility::sees(Index triangle, const Vector3& point) const {
  const auto [a, b, c] = corners(triangle);
  const Vector3 from = (a + b + c) / 3;
  const bool faces = (point - from).dot((b - a).cross(c - a)) > 0;
  const auto& first = bodies_->first_triangle;
  const auto body = std::ranges::upper_bound(first, triangle) - first.begin() - 1;
  Sight sight{{},
              static_cast<unsigned>(body),
              static_cast<unsigned>(triangle - first[body]),
              faces ? bodies_->self_occlusion : SelfOcclusion::excluded};
  return bodies_->is_clear(from, point, sight);
}

bool Visibility::is_clear(const Vector3& from, const Vector3& to) const {
  constexpr unsigned nobody = -1U;
  Sight sight{{}, nobody, nobody, SelfOcclusion::included};
  return bodies_->is_clear(from, to, sight);
}

}  // namespace idiophone::radiation
