// The first half of a step: what only needs the pressures before it.

/// Advances the memory of the faces of all layers, and then the nodes. One call for each of them.
/// @param advances      whether the nodes get their new pressures. Otherwise, they only get their new rates, of which
///                      walls take something
/// @param cell          that takes the pressure of a node; -1 for none
/// @param sources       what surfaces add to the rates of the nodes, from this place on
/// @param next          the pressures after the step
kernel void begin_step(int faces, int count, constant struct LayerTable* layers, int first, int row, int plane,
                       global const float* decay, global float* memory, int nodes, int cells, int advances,
                       global const int* first_link, global const int* to, global const float* area,
                       global const float* stiffness, global const int* cell, int first_source,
                       global const float* sources, global float* rate, global const float* pressure,
                       global float* next) {
  const int i = get_global_id(0);
  if (i < faces) {
    stretch_face(i, count, layers, first, row, plane, decay, pressure, memory);
    return;
  }
  const int node = i - faces;
  if (node >= nodes) {
    return;
  }
  const float inflow = inflow_of_node(node, cells, first_link, to, area, stiffness, pressure);
  const float gain = rate[node] + (inflow + sources[first_source + node]);
  rate[node] = gain;
  if (advances) {
    publish_node(node, cells, cell[node], pressure[cells + node] + gain, next);
  }
}
