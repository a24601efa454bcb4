// A bar of two boxes, joined at the seam in the middle.
SetFactory("OpenCASCADE");
DefineConstant[ length = 0.2, width = 0.03, size = 0.03, hexahedra = 0 ]; // m
Box(1) = {0, 0, 0, length / 2, width, width};
Box(2) = {length / 2, 0, 0, length / 2, width, width};
Coherence;
small = 1e-6;
Physical Volume("bar") = {1, 2};
Physical Surface("seam") = Surface In BoundingBox{length / 2 - small, -small, -small, length / 2 + small, width + small, width + small};
Physical Surface("left") = Surface In BoundingBox{-small, -small, -small, small, width + small, width + small};
Mesh.MeshSizeMax = size;
If (hexahedra)
  Transfinite Curve {:} = 3;
  Transfinite Surface {:};
  Transfinite Volume {:};
  Recombine Surface {:};
EndIf
