// Solid sphere, centred at the origin; its poles, above and below the centre, are nodes.
SetFactory("OpenCASCADE");
DefineConstant[
  radius = {0.05, Min 0, Name "Sphere/1 Radius (m)"}
  size = {0.02, Min 0, Name "Sphere/2 Element size (m)"}
];
If (radius <= 0 || size <= 0)
  Error("radius and size must be above 0");
  Exit;
EndIf

Sphere(1) = {0, 0, 0, radius};
Mesh.Algorithm3D = 1; // Delaunay: HXT would make another mesh in each run
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;

Physical Volume("body") = {1};
Physical Surface("surface") = Boundary{ Volume{1}; };
