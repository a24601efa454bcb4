// A step of the whole subdomain in one kernel: it only reads pressures before the step, and only writes those after it.

/// Advances nodes and cells. The first planes of calls are for the nodes, which take longest, the others for the cells.
/// @param node_planes    how many planes are for the nodes
/// @param cells          length of an array of cells: pressures of nodes follow
/// @param first          number of the first cell of the subdomain in such an array; rows and planes are so long
/// @param mirrored       whether a rigid floor is below: the cells there are mirror images
/// @param advances       whether the nodes get their new pressures. Otherwise, they only get their new rates, of which
///                       walls take something
/// @param square         C^2
/// @param memory         of the layers: the faces before the step and after it, at these places, and the cells
/// @param held           whether a cell has the pressure of a node, or is solid: [cells]
/// @param first_source   place in `sources` of what surfaces add to the rate of the first node
/// @param next           the pressures after the step
kernel void step_field(int width, int height, int depth, int node_planes, int nodes, int cells, int first, int row,
                       int plane, int mirrored, int advances, float square, int layers,
                       constant struct LayerTable* layer_tables, global const float* decay, int faces, int next_faces,
                       int cell_memory, global float* memory, global const uchar* held,
                       global const struct NodeTable* node_tables, global const struct Link* links, int first_source,
                       global const float* sources, global float* node_rate, global const float* pressure,
                       global float* rate, global float* next) {
  const int x = get_global_id(0), y = get_global_id(1), z = (int)get_global_id(2) - node_planes;
  if (x >= width || y >= height || z >= depth) {
    return;
  }
  if (z < 0) {
    const int node = ((z + node_planes) * height + y) * width + x;
    if (node < nodes) {
      const float inflow = inflow_of_node(node, cells, node_tables, links, pressure);
      const float gain = node_rate[node] + (inflow + sources[first_source + node]);
      node_rate[node] = gain;
      if (advances) {
        publish_node(node, cells, node_tables[node].cell, pressure[cells + node] + gain, next);
      }
    }
    return;
  }
  const int cell = first + x + y * row + z * plane;
  const float gain = rate_of_cell(x, y, z, row, plane, square, layers, layer_tables, decay, memory + faces,
                                  memory + next_faces, memory + cell_memory, pressure + cell, rate[cell]);
  if (held[cell]) {
    return;
  }
  rate[cell] = gain;
  next[cell] = pressure[cell] + gain;
  if (mirrored && z == 0) {
    next[cell - plane] = pressure[cell] + gain;  // held cells need none: no node is linked to its mirror image
  }
}
