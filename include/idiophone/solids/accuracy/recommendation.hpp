#pragma once
// The cheapest mesh for a wanted accuracy of pitch.

#include <optional>

#include "idiophone/solids/accuracy/pitch_error.hpp"

namespace idiophone::accuracy {

/// What is wanted of a mesh.
struct Accuracy {
  double cents;      ///< above 0
  double frequency;  ///< Hz, up to which
};

struct Recommendation {
  Cells cells;
  int layers = 1;        ///< through the thickness
  double error = 0.0;    ///< pitch_error at the frequency, cents
  double seconds = 0.0;  ///< processor time of a second of sound, s
};

/// Processor time of a second of sound with a mesh that exists, s, by the speeds of docs/method/performance.md.
/// @param step  stable step of the body, s
[[nodiscard]] double seconds_of(const mesh::Statistics& mesh, element::Type type, double step);

/// The cheapest mesh of a kind with even cells whose pitch_error is at most the wanted one; nothing if there is none
/// within 500 cells along the body.
/// @param kind  tet10 or hex
/// @param volume  of the body, m3
[[nodiscard]] std::optional<Recommendation> recommend(element::Kind kind, const Extents& body, double volume,
                                                      const scene::Material& material, const Accuracy& wanted);

}  // namespace idiophone::accuracy
