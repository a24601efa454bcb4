// What surfaces add to the nodes in all steps of an audio sample.

/// What velocities change from half a step before the beginning of each step to half a step after it.
/// @param samples  that are kept, in a ring, in which the oldest one has this place: [samples x signals]
/// @param weights  [steps x samples], the oldest sample first
/// @param change   [steps x signals]
kernel void change_velocities(int signals, int steps, int samples, int oldest, constant float* weights,
                              global const float* sample, global float* change) {
  const int i = get_global_id(0);
  if (i >= signals) {
    return;
  }
  for (int step = 0; step < steps; ++step) {
    float sum = 0.0F;
    for (int n = 0, place = oldest; n < samples; ++n, place = place + 1 < samples ? place + 1 : 0) {
      sum += weights[step * samples + n] * sample[place * signals + i];
    }
    change[step * signals + i] = sum;
  }
}

/// As waves::SurfaceSources::Piece.
struct Piece {
  int node, triangle;
  float weight;
};

/// The sums of pieces of triangles in front of nodes.
/// @param first_piece  of each node, and one more
/// @param sources      [steps x nodes]
kernel void add_sources(int nodes, int steps, int triangles, global const int* first_piece,
                        global const struct Piece* pieces, global const float* change, global float* sources) {
  const int i = get_global_id(0);
  if (i >= nodes * steps) {
    return;
  }
  const int step = i / nodes, node = i % nodes;
  float sum = 0.0F;
  for (int piece = first_piece[node]; piece < first_piece[node + 1]; ++piece) {
    sum += pieces[piece].weight * change[step * triangles + pieces[piece].triangle];
  }
  sources[i] = sum;
}
