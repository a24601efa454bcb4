// The numbers of a step of a whole subdomain, in the language that C++ and OpenCL C have in common.

#ifndef IDIOPHONE_STEP_TABLE
#define IDIOPHONE_STEP_TABLE

#ifdef __cplusplus
namespace idiophone::waves {
#endif

struct StepTable {
  int width, height, depth;            ///< of the subdomain, in cells
  int first, row, plane;               ///< in an array of cells: its first cell, and how far apart rows and planes are
  int cells;                           ///< length of an array of cells: pressures of nodes follow
  int mirrored;                        ///< whether a rigid floor is below: the cells there are mirror images
  float square;                        ///< C^2
  int layers;                          ///< how many absorbing layers there are
  int faces, next_faces, cell_memory;  ///< places in their memory: of faces before the step and after it, of cells
  int nodes;                           ///< that the subdomain owns
  int node_planes;                     ///< how many planes of calls are for them
  int nodes_advance;  ///< whether they get new pressures. Otherwise, they only get new rates, of which walls take
                      ///< something
  int first_source;   ///< place of what surfaces add to the rate of the first node
};

#ifdef __cplusplus
}  // namespace idiophone::waves
#endif

#endif
