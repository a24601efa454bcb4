// The formulas of a step, in the language that C++ and OpenCL C have in common: processors and accelerators compute the
// same. Names are those of docs/method/waves.md.

#ifndef IDIOPHONE_STEP_FORMULAS
#define IDIOPHONE_STEP_FORMULAS

#ifdef __cplusplus
namespace idiophone::waves {
#endif

/// What flows into a cell of open air along an axis, from the pressures of the two cells next to it.
static inline float inflow_along(float here, float before, float after) {
  return (before - here) + (after - here);
}

/// What flows into a cell of open air along all axes.
static inline float inflow_of_cell(float along_x, float along_y, float along_z) {
  return (along_x + along_y) + along_z;
}

/// The memory of a face at the outer side of a cell in an absorbing layer, after a step.
/// @param kept  the part of it that remains
static inline float memory_of_face(float kept, float memory, float here, float outer) {
  return kept * memory + (kept - 1.0F) * (outer - here);
}

/// The memory of a cell in an absorbing layer, after a step.
/// @param kept       the part of it that remains
/// @param plain      what flows into the cell along the axis of the layer
/// @param stretched  the memory of its outer face less that of its inner one
static inline float memory_of_cell(float kept, float memory, float plain, float stretched) {
  return kept * memory + (kept - 1.0F) * (plain + stretched);
}

/// What half a derivative would take from a quantity if it had no past.
/// @param weights  the sum over all relaxations
/// @param gain     of the quantity in the step without the half derivative
static inline float loss_without_past(float weights, float value, float gain) {
  return weights * (value + gain / 2.0F);
}

/// What half a derivative takes, for a loss of all relaxations with their past.
/// @param ratio  of the half derivative to the whole one
static inline float loss_in_step(float loss, float weights, float ratio) {
  return loss * (ratio / (1.0F + ratio * weights / 2.0F));
}

/// The past of a relaxation after a step.
static inline float past_after_step(float past, float pace, float value, float gain, float loss) {
  return past + pace * (value + (gain - loss) / 2.0F - past);
}

#ifdef __cplusplus
}  // namespace idiophone::waves
#endif

#endif
