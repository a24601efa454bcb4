// Solid sphere, centred at the origin, with small elements around its lowest point, where it is to touch.
SetFactory("OpenCASCADE");
DefineConstant[
  radius = {0.01, Min 0, Name "Sphere/1 Radius (m)"}
  size = {0.002, Min 0, Name "Sphere/2 Largest element size (m)"}
  pole_size = {0.0002, Min 0, Name "Sphere/3 Element size at the lowest point (m)"}
  pole_radius = {0.0008, Min 0, Name "Sphere/4 Distance from that point to which it holds (m)"}
];
If (radius <= 0 || size <= 0 || pole_size <= 0 || pole_radius <= 0)
  Error("radius, size, pole_size and pole_radius must be above 0");
  Exit;
EndIf
If (pole_radius >= radius)
  Error("pole_radius must be below radius");
  Exit;
EndIf

Sphere(1) = {0, 0, 0, radius};
Point(10) = {0, 0, -radius};
Field[1] = Distance;
Field[1].PointsList = {10};
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].DistMin = pole_radius;
Field[2].DistMax = radius;
Field[2].SizeMin = pole_size;
Field[2].SizeMax = size;
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeFromCurvature = 0;
Mesh.Algorithm3D = 1; // Delaunay: HXT would make another mesh in each run

Physical Volume("body") = {1};
Physical Surface("surface") = Boundary{ Volume{1}; };
