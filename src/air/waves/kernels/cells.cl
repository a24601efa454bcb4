// A step of a cell in open air and in absorbing layers.

static int along(int axis, int x, int y, int z) {
  return axis == 0 ? x : axis == 1 ? y : z;
}

/// The memory of the outer face of a cell in a layer, after a step.
/// @param i       place of the cell along the axis
/// @param here    the pressure of the cell, among the others
/// @param memory  of the face, before the step
static float stretched_face(constant struct LayerTable* layer, int i, global const float* decay,
                            global const float* here, float memory) {
  return memory_of_face(decay[layer->face_decay + i], memory, here[0], here[layer->outwards]);
}

/// What a layer adds to the rate of a cell, over C^2. Advances the memories of the cell and of its outer face. A call
/// computes the inner face, too: no call needs what another one writes.
/// @param faces  memory of the faces before the step
/// @param next   likewise, after it
/// @param cells  memory of the cells
static float stretched_inflow(constant struct LayerTable* layer, int x, int y, int z, global const float* decay,
                              global const float* here, global const float* faces, global float* next,
                              global float* cells) {
  const int axis = layer->axis, i = along(axis, x, y, z), inner = i + layer->inner;
  const int place = layer->memory + x + y * layer->row + z * layer->plane, inner_place = place + layer->inwards;
  const float outer_face = stretched_face(layer, i, decay, here, faces[place]);
  next[place] = outer_face;
  float inner_face = 0.0F;  // that of the whole layer
  if (inner >= layer->faces_from && inner < layer->faces_to) {
    inner_face = stretched_face(layer, inner, decay, here - layer->outwards, faces[inner_place]);
    if (inner < layer->from[axis] || inner >= layer->to[axis]) {
      next[inner_place] = inner_face;  // of a ghost cell
    }
  }
  const float stretched = outer_face - inner_face;
  const float plain = inflow_along(here[0], here[layer->outwards], here[-layer->outwards]);
  const float memory = memory_of_cell(decay[layer->cell_decay + i], cells[place], plain, stretched);
  cells[place] = memory;
  return stretched + memory;
}

/// The rate of a cell after a step, if it is one of open air. Advances the memory of the layers.
/// @param memory  of the layers
/// @param here    the pressure of the cell, among the others
/// @param rate    before the step
static float rate_of_cell(int x, int y, int z, struct StepTable step, constant struct LayerTable* layers,
                          global const float* decay, global float* memory, global const float* here, float rate) {
  for (constant struct LayerTable* layer = layers; layer < layers + step.layers; ++layer) {
    if (x >= layer->from[0] && x < layer->to[0] && y >= layer->from[1] && y < layer->to[1] && z >= layer->from[2] &&
        z < layer->to[2]) {
      rate += step.square * stretched_inflow(layer, x, y, z, decay, here, memory + step.faces,
                                             memory + step.next_faces, memory + step.cell_memory);
    }
  }
  return rate + step.square * inflow_of_cell(inflow_along(*here, here[-1], here[1]),
                                             inflow_along(*here, here[-step.row], here[step.row]),
                                             inflow_along(*here, here[-step.plane], here[step.plane]));
}
