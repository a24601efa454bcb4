// Mistakes in how a body moves: by its finite elements or by its modes.

#include "mistaken.hpp"

namespace idiophone::scene {

using MistakenModels = Mistaken;

TEST_F(MistakenModels, LargeAmplitudes) {
  expect({
      {"fixed: [rim]", "model: {type: finite_elements, large_amplitudes: true}",
       "deck.yaml:6:76: bodies.plate.model.large_amplitudes: has no meaning with type finite_elements: only modal has "
       "it"},
      {"fixed: [rim]", "model: {type: modal, count: 9, stretching_tolerance: 0.01}",
       "deck.yaml:6:76: bodies.plate.model.stretching_tolerance: has no meaning without large_amplitudes: true"},
      {"fixed: [rim]", "model: {type: modal, count: 9, large_amplitudes: true, stretching_tolerance: 0}",
       "deck.yaml:6:122: bodies.plate.model.stretching_tolerance: must be at least 1e-06 and at most 0.1, found 0"},
  });
}

}  // namespace idiophone::scene
