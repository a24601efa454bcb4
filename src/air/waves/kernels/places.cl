// Some numbers of an array.

kernel void gather(int count, global const int* places, global const float* values, global float* gathered) {
  const int i = get_global_id(0);
  if (i < count) {
    gathered[i] = values[places[i]];
  }
}

kernel void scatter(int count, global const int* places, global const float* gathered, global float* values) {
  const int i = get_global_id(0);
  if (i < count) {
    values[places[i]] = gathered[i];
  }
}
