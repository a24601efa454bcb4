// A step of cells in open air and in absorbing layers.

static int along(int axis, int x, int y, int z) {
  return axis == 0 ? x : axis == 1 ? y : z;
}

static int place_in(constant struct LayerTable* layer, int x, int y, int z) {
  return layer->memory + x + y * layer->row + z * layer->plane;
}

/// Advances the memory of a face.
/// @param number  of the face among those of all layers
/// @param first   number of the first cell in arrays of the subdomain, whose rows and planes are so long
static void stretch_face(int number, int count, constant struct LayerTable* layers, int first, int row, int plane,
                         global const float* decay, global const float* pressure, global float* memory) {
  constant struct LayerTable* layer = layers;
  while (layer + 1 < layers + count && number >= (layer + 1)->first_face) {
    ++layer;
  }
  number -= layer->first_face;
  const int in_row = layer->faces_to[0] - layer->faces_from[0];
  const int in_column = layer->faces_to[1] - layer->faces_from[1];
  const int x = layer->faces_from[0] + number % in_row;
  const int y = layer->faces_from[1] + number / in_row % in_column;
  const int z = layer->faces_from[2] + number / in_row / in_column;
  const int cell = first + x + y * row + z * plane;
  const int place = place_in(layer, x, y, z);
  const float kept = decay[layer->face_decay + along(layer->axis, x, y, z)];
  memory[place] = memory_of_face(kept, memory[place], pressure[cell], pressure[cell + layer->outwards]);
}

/// What a layer adds to the rate of a cell, over C^2. Advances the memory of the cell.
static float stretched_inflow(constant struct LayerTable* layer, int x, int y, int z, global const float* decay,
                              global const float* here, global const float* faces, global float* memory) {
  const int place = place_in(layer, x, y, z);
  const float kept = decay[layer->cell_decay + along(layer->axis, x, y, z)];
  const float stretched = faces[place] - faces[place + layer->inwards];
  const float plain = inflow_along(*here, here[layer->outwards], here[-layer->outwards]);
  memory[place] = memory_of_cell(kept, memory[place], plain, stretched);
  return stretched + memory[place];
}

/// Advances all cells of the subdomain.
/// @param mirrored  whether a rigid floor is below: the cells there are mirror images
/// @param held      whether a cell has the pressure of a node, or is solid: [cells]
/// @param next      the pressures after the step, with those of the nodes and of their cells
kernel void step_cells(int width, int height, int depth, int mirrored, int count, constant struct LayerTable* layers,
                       int first, int row, int plane, float square, global const uchar* held, global const float* decay,
                       global const float* faces, global float* memory, global const float* pressure,
                       global float* rate, global float* next) {
  const int x = get_global_id(0), y = get_global_id(1), z = get_global_id(2);
  if (x >= width || y >= height || z >= depth) {
    return;
  }
  const int cell = first + x + y * row + z * plane;
  global const float* here = pressure + cell;
  float gain = rate[cell];
  for (constant struct LayerTable* layer = layers; layer < layers + count; ++layer) {
    if (x >= layer->from[0] && x < layer->to[0] && y >= layer->from[1] && y < layer->to[1] && z >= layer->from[2] &&
        z < layer->to[2]) {
      gain += square * stretched_inflow(layer, x, y, z, decay, here, faces, memory);
    }
  }
  gain += square * inflow_of_cell(inflow_along(*here, here[-1], here[1]), inflow_along(*here, here[-row], here[row]),
                                  inflow_along(*here, here[-plane], here[plane]));
  if (!held[cell]) {
    rate[cell] = gain;
    next[cell] = *here + gain;
  }
  if (mirrored && z == 0) {
    next[cell - plane] = next[cell];
  }
}
