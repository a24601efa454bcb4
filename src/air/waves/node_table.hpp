// A node at surfaces as an accelerator sees it, in the language that C++ and OpenCL C have in common.

#ifndef IDIOPHONE_NODE_TABLE
#define IDIOPHONE_NODE_TABLE

#ifdef __cplusplus
namespace idiophone::waves {
#endif

/// One more of them, whose links are none, ends a table.
struct NodeTable {
  int first_link;   ///< its links are those before the first one of the next node
  int cell;         ///< that takes its pressure; -1 for none
  float stiffness;  ///< C^2/V
};

#ifdef __cplusplus
}  // namespace idiophone::waves
#endif

#endif
