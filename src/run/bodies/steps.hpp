#pragma once
// How long the steps of a run are.

#include <optional>
#include <string>

#include "idiophone/run/bodies/preparation.hpp"

namespace idiophone::bodies {

/// Whether all of a body of finite elements is fixed or driven, so that nothing limits its step.
[[nodiscard]] bool is_held_everywhere(const Preparation& ready, std::size_t body);

/// Least mass of the surface nodes over their areas, of bodies that are not held everywhere, kg/m2; infinity where
/// all are.
[[nodiscard]] double lightest_surface(const Preparation& ready);

/// The largest stable step of bodies that feel the resistance of the air, s: dt/stable + r dt/(2 m) <= 1 suffices for
/// an oscillator with the stable step `stable` and one more dashpot r, since w^2 dt^2/4 + c dt/2 <= dt/stable.
[[nodiscard]] double stable_step_in_air(const Preparation& ready);

/// The step that the deck asks for, s.
[[nodiscard]] std::optional<double> own_step(const scene::Scene& scene);

/// What contacts do to the smallest stable step of the bodies, as a sentence that names them; empty where elements set
/// that step.
[[nodiscard]] std::string contact_as_cause(const Preparation& ready);

/// m; see motion::choose_steps_per_sample.
[[nodiscard]] int find_steps_per_sample(const Preparation& ready);

}  // namespace idiophone::bodies
