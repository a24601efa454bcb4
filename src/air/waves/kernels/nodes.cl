// A step of nodes at surfaces. Their pressures follow those of so many `cells` in an array of pressures.

/// As waves::Link.
struct Link {
  int to;
  float area;
};

/// What the links of a node add to its rate.
static float inflow_of_node(int node, int cells, global const struct NodeTable* tables, global const struct Link* links,
                            global const float* pressure) {
  const float here = pressure[cells + node];
  float flow = 0.0F;
  for (int link = tables[node].first_link; link < tables[node + 1].first_link; ++link) {
    flow += links[link].area * (pressure[links[link].to] - here);
  }
  return tables[node].stiffness * flow;
}

/// The pressure of a node after a step, for itself and for its cell.
/// @param cell  that takes its pressure; -1 for none
static void publish_node(int node, int cells, int cell, float pressure, global float* next) {
  next[cells + node] = pressure;
  if (cell >= 0) {
    next[cell] = pressure;
  }
}

/// The rates of nodes without sources.
/// @param gain  the new rates
kernel void node_rates_at_rest(int nodes, int cells, global const struct NodeTable* tables,
                               global const struct Link* links, global const float* pressure, global const float* rate,
                               global float* gain) {
  const int node = get_global_id(0);
  if (node < nodes) {
    gain[node] = rate[node] + inflow_of_node(node, cells, tables, links, pressure);
  }
}

/// What half a derivative takes from a quantity in a step.
/// @param i        its number among so many
/// @param weights  of the relaxations; `all` is their sum
/// @param past     of each relaxation: [quantities]. It advances if asked for
static float half_derivative(int i, int quantities, float all, constant float* weights, constant float* paces,
                             float ratio, float value, float gain, int advances, global float* past) {
  float loss = loss_without_past(all, value, gain);
  for (int k = 0; k < RELAXATIONS; ++k) {
    loss -= weights[k] * past[k * quantities + i];
  }
  loss = loss_in_step(loss, all, ratio);
  for (int k = 0; advances && k < RELAXATIONS; ++k) {
    global float* one = past + k * quantities + i;
    *one = past_after_step(*one, paces[k], value, gain, loss);
  }
  return loss;
}

/// What friction takes from the flow between nodes.
kernel void slow_ways(int ways, int quantities, int cells, int advances, float all, constant float* weights,
                      constant float* paces, global const float* ratio, global const int* node,
                      global const int* other, global const float* pressure, global float* flow, global float* past,
                      global float* slowed) {
  const int i = get_global_id(0);
  if (i >= ways) {
    return;
  }
  const float push = pressure[cells + other[i]] - pressure[cells + node[i]];
  slowed[i] = half_derivative(i, quantities, all, weights, paces, ratio[i], flow[i], push, advances, past);
  if (advances) {
    flow[i] += push - slowed[i];
  }
}

/// Takes from the rates of nodes what friction takes from their ways.
kernel void slow_nodes(int nodes, global const int* first_way, global const float* weight, global const float* slowed,
                       global float* rate) {
  const int node = get_global_id(0);
  if (node >= nodes) {
    return;
  }
  for (int way = first_way[node]; way < first_way[node + 1]; ++way) {
    rate[node] -= weight[way] * slowed[way];
  }
}

/// Takes heat from the changes of pressure.
/// @param place   of a node among those that heat is taken from; -1 for none
/// @param change  the rate without what heat takes
kernel void cool_nodes(int nodes, int quantities, int cells, int advances, float all, constant float* weights,
                       constant float* paces, global const float* ratio, global const int* place,
                       global const float* pressure, global const float* rate, global float* past,
                       global float* change) {
  const int node = get_global_id(0);
  if (node >= nodes) {
    return;
  }
  change[node] = rate[node];
  const int i = place[node];
  if (i >= 0) {
    change[node] -= half_derivative(i, quantities, all, weights, paces, ratio[i], pressure[cells + node], rate[node],
                                    advances, past);
  }
}

/// Pressures of nodes after a step in which walls took something.
kernel void advance_nodes(int nodes, int cells, global const struct NodeTable* tables, global const float* pressure,
                          global const float* change, global float* next) {
  const int node = get_global_id(0);
  if (node < nodes) {
    publish_node(node, cells, tables[node].cell, pressure[cells + node] + change[node], next);
  }
}

/// Pressures of nodes after half a step.
kernel void forecast_nodes(int nodes, int cells, global const float* pressure, global const float* change,
                           global float* forecast) {
  const int node = get_global_id(0);
  if (node < nodes) {
    forecast[node] = pressure[cells + node] + 0.5F * change[node];
  }
}
