#pragma once
// Sound maps: what the sound of any blow on a body needs (van den Doel and Pai 1996; docs/use/sound_map.md).

#include <array>
#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/types.hpp"
#include "idiophone/solids/modal_bodies/stretching.hpp"

namespace idiophone::sound_maps {

/// Sound pressure at one receiver of the deck.
struct MapListener {
  std::string name;                            ///< of the channel, e.g. "ears.left"
  Vector3 position = Vector3::Zero();          ///< m
  double delay = 0.0;                          ///< travel time from the nearest vertex of the surface, s
  std::vector<std::complex<double>> pressure;  ///< [modes] after the delay, Pa for a modal velocity of 1 sqrt(kg) m/s
};

/// Sound pressure far away in all directions, as it would be at `distance` if it fell with 1/r from far away down to
/// there. At r metres it is distance/r times as large, and arrives r/speed after it left the centre.
struct MapSphere {
  double distance = 1.0;           ///< from the body's centre, m
  std::size_t rings = 0;           ///< polar angles: nodes of Gauss' quadrature in the cosine, from +1 to -1
  std::size_t azimuths = 0;        ///< directions of a ring, evenly spaced from the x axis towards the y axis
  std::vector<Vector3> direction;  ///< [rings x azimuths] unit vectors from the centre
  std::vector<double> weight;      ///< [directions] solid angle of each; the sum is 4 pi
  std::vector<std::complex<double>> pressure;  ///< [modes x directions] Pa for a modal velocity of 1 sqrt(kg) m/s
};

/// What a hammer needs to know of a solid's material.
struct MapMaterial {
  std::string name;
  double density = 0.0;  ///< kg/m3
  double young = 0.0;    ///< Young's modulus, Pa; the largest of an orthotropic material
  double poisson = 0.0;  ///< Poisson's ratio; 0 for an orthotropic material
};

/// Numbers that tell whether another mesh is the same one but for its size and its place.
struct MeshShape {
  std::string kind;                  ///< "tet10, 412 nodes, 180 elements"
  Vector3 middle = Vector3::Zero();  ///< mean of the nodes, m
  double size = 0.0;                 ///< root of the mean square of the distances of the nodes from there, m
  /// Means of cos(k.r) and sin(k.r) over the nodes, then over those that are held or driven, 0 without: r from the
  /// middle over the size, and six vectors k without unit (solid_facts.cpp).
  Eigen::Matrix<double, 6, 4> pattern = Eigen::Matrix<double, 6, 4>::Zero();
};

/// What the modes of a body with one material depend on, so that another map can be made of them for another density,
/// stiffness, damping or size (rescaled_map.hpp).
struct ScalableModes {
  using Stiffness = Eigen::Matrix<double, 6, 6>;

  std::string mesh;                         ///< mesh::Mesh::hash
  std::optional<MeshShape> mesh_shape;      ///< none in maps of older versions
  std::string held;                         ///< fixed and driven groups with their axes: "rim xyz", or "nothing"
  Stiffness stiffness = Stiffness::Zero();  ///< scene::StiffnessMatrix along the axes of the scene, Pa
  std::vector<double> lossless_frequency;   ///< [modes] eigenmodes::Mode, Hz
};

struct SoundMap {
  std::string name;                     ///< of the deck
  std::string body;                     ///< its name in the deck
  std::string kind;                     ///< "solid", or an ideal body: "membrane", "string", "bar", "plate"
  std::string code_version;             ///< e.g. "0.2.0"
  std::string deck_text;                ///< verbatim
  std::vector<std::string> overrides;   ///< the --set arguments, verbatim
  std::string resolved_deck;            ///< with overrides and defaults
  std::optional<MapMaterial> material;  ///< of a solid
  double mass = 0.0;                    ///< of the body, kg
  Vector3 centre = Vector3::Zero();     ///< of mass, m
  double air_density = 1.21;            ///< kg/m3
  double air_speed = 343.0;             ///< of sound, m/s
  std::string radiation;                ///< the model, e.g. "boundary_elements", or "rayleigh" of ideal bodies

  std::vector<double> frequency;          ///< [modes] without damping, Hz, ascending
  std::vector<double> material_decay;     ///< [modes] of the amplitude, by material and supports, 1/s
  std::vector<double> radiation_decay;    ///< [modes] of the amplitude, by the sound that is radiated, 1/s
  std::vector<double> mesh_error;         ///< [modes] cents by which the mesh makes each frequency too high, estimated;
                                          ///< NaN where unknown. Empty if unknown for all
  std::optional<ScalableModes> scalable;  ///< none where more than one material decides, or something besides
  modal_bodies::Stretching stretching;    ///< of large vibrations; none where they are taken as small

  std::vector<Vector3> vertices;                ///< of the surface, undeformed, m
  std::vector<std::array<Index, 3>> triangles;  ///< vertex numbers, in the order that makes normals point outwards
  std::vector<float> shape;                     ///< [modes x vertices x 3] for unit modal mass, 1/sqrt(kg)
  std::vector<MapListener> listeners;
  MapSphere sphere;

  [[nodiscard]] std::size_t modes() const { return frequency.size(); }
  /// Of the amplitude of a mode, 1/s: it falls as exp(-decay t).
  [[nodiscard]] double decay(std::size_t mode) const { return material_decay[mode] + radiation_decay[mode]; }
  /// Of one mode, [3 x vertices].
  [[nodiscard]] std::span<const float> shape_of(std::size_t mode) const {
    return std::span(shape).subspan(mode * 3 * vertices.size(), 3 * vertices.size());
  }
};

/// Of the errors that the mesh makes, the largest, for people: "the mesh makes frequencies wrong by up to 12 cents
/// (mode 3), as estimated for 20 of 40 modes"; empty if none is known. Rigid motions on soft supports do not count
/// (eigenmodes::is_rigid_motion()).
[[nodiscard]] std::string mesh_error_text(const SoundMap& map);

}  // namespace idiophone::sound_maps
