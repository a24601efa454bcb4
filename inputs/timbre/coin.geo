// Disc: axis z through the origin, z in [-thickness/2, thickness/2].
DefineConstant[
  radius = {0.05, Min 0, Name "Coin/1 Radius (m)"}
  thickness = {0.01, Min 0, Name "Coin/2 Thickness (m)"}
  size = {0.02, Min 0, Name "Coin/3 Element size (m)"}
];
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, -thickness / 2, 0, 0, thickness, radius};
Mesh.MeshSizeMax = size;
Physical Volume("body") = {1};
