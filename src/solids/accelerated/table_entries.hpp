// Elements and nodes as an accelerator sees them, in the language that C++ and OpenCL C have in common.

#ifndef IDIOPHONE_TABLE_ENTRIES
#define IDIOPHONE_TABLE_ENTRIES

#ifdef __cplusplus
namespace idiophone::accelerated {
#endif

struct ElementEntry {
  int region;
  int geometry;  ///< number of the first geometry; with one for all points, -1 less this number
};

/// One more of them ends a table.
struct NodeEntry {
  double inverse_mass;  ///< 1/kg
  int places;  ///< number of the first place of the node in elements; the next node has those after its last one
  int held;    ///< bits 1, 2, 4 for components x, y, z
};

#ifdef __cplusplus
}  // namespace idiophone::accelerated
#endif

#endif
