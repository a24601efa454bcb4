#pragma once
// How two surfaces touch.

#include "idiophone/instruments/score/action.hpp"
#include "idiophone/instruments/touching/contact_events.hpp"

namespace idiophone::touching {

/// By Hertz' law, N/m^(3/2): 4/3 E sqrt(R), with 1/E and 1/R as sums of both sides (K. L. Johnson, Contact Mechanics,
/// 1985, section 4.2).
[[nodiscard]] double hardness_of(const Surface& first, const Surface& second);

/// An impact of an impulse, as long as the surfaces make it, but at most 0.1 s.
/// @param mass  that the impulse moves, kg
[[nodiscard]] score::Hammer impact_of(double impulse, double mass, const Surface& first, const Surface& second);

/// Scraping or rolling at the origin. Heights of roughness are added up as their squares.
[[nodiscard]] score::Stroke stroke_of(score::Stroke::Kind kind, double mass, const Surface& first,
                                      const Surface& second);

}  // namespace idiophone::touching
