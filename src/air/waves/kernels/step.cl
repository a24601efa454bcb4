// A step of the whole subdomain in one kernel: it only reads pressures before the step, and only writes those after it.

/// Advances nodes and cells. The first planes of calls are for the nodes, which take longest, the others for the cells.
/// @param memory   of the layers
/// @param held     whether a cell has the pressure of a node, or is solid: [cells]
/// @param sources  what surfaces add to the rates of nodes
/// @param next     the pressures after the step
kernel void step_field(struct StepTable step, constant struct LayerTable* layers, global const float* decay,
                       global float* memory, global const uchar* held, global const struct NodeTable* node_tables,
                       global const struct Link* links, global const float* sources, global float* node_rate,
                       global const float* pressure, global float* rate, global float* next) {
  const int x = get_global_id(0), y = get_global_id(1), z = (int)get_global_id(2) - step.node_planes;
  if (x >= step.width || y >= step.height || z >= step.depth) {
    return;
  }
  if (z < 0) {
    const int node = ((z + step.node_planes) * step.height + y) * step.width + x;
    if (node < step.nodes) {
      const float inflow = inflow_of_node(node, step.cells, node_tables, links, pressure);
      const float gain = node_rate[node] + (inflow + sources[step.first_source + node]);
      node_rate[node] = gain;
      if (step.nodes_advance) {
        publish_node(node, step.cells, node_tables[node].cell, pressure[step.cells + node] + gain, next);
      }
    }
    return;
  }
  const int cell = step.first + x + y * step.row + z * step.plane;
  const float gain = rate_of_cell(x, y, z, step, layers, decay, memory, pressure + cell, rate[cell]);
  if (held[cell]) {
    return;
  }
  rate[cell] = gain;
  next[cell] = pressure[cell] + gain;
  if (step.mirrored && z == 0) {
    next[cell - step.plane] = pressure[cell] + gain;  // no step reads those of held cells
  }
}
