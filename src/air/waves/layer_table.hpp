// An absorbing layer as an accelerator sees it, in the language that C++ and OpenCL C have in common.

#ifndef IDIOPHONE_LAYER_TABLE
#define IDIOPHONE_LAYER_TABLE

#ifdef __cplusplus
namespace idiophone::waves {
#endif

/// Places of cells are counted from the first cell of the subdomain. The memory of cell (x, y, z) and of its outer face
/// has the place memory + x + y row + z plane.
struct LayerTable {
  int axis;
  int outwards;                ///< from a cell to the next one outwards, in arrays of the subdomain
  int inwards;                 ///< to the next one inwards, in the memory
  int inner;                   ///< to the next one inwards, along the axis: 1 or -1
  int row, plane, memory;      ///< of the memory
  int face_decay, cell_decay;  ///< places of the decays of cell 0 along the axis
  int from[3], to[3];          ///< cells of the layer
  int faces_from, faces_to;    ///< cells whose outer faces they need, along the axis
};

#ifdef __cplusplus
}  // namespace idiophone::waves
#endif

#endif
