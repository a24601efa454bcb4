// Solid sphere, centred at the origin, with small elements around its lowest point, where it is to touch. Hexahedra make
// a block, narrow at its lower end, and six caps between its faces and the sphere.
DefineConstant[
  radius = {0.01, Min 0, Name "Sphere/1 Radius (m)"}
  size = {0.002, Min 0, Name "Sphere/2 Largest element size (m)"}
  pole_size = {0.0002, Min 0, Name "Sphere/3 Element size at the lowest point (m)"}
  pole_radius = {0.0008, Min 0, Name "Sphere/4 Distance from that point to which it holds (m)"}
  hexahedra = {0, Choices {0, 1}, Name "Sphere/5 Hexahedra instead of tetrahedra"}
];
If (radius <= 0 || size <= 0 || pole_size <= 0 || pole_radius <= 0)
  Error("radius, size, pole_size and pole_radius must be above 0");
  Exit;
EndIf
If (pole_radius >= radius)
  Error("pole_radius must be below radius");
  Exit;
EndIf

If (hexahedra)
  SetFactory("Built-in");
  // Half the width of the cap at the lowest point, and its depth.
  widest = radius / Sqrt(3);
  pole = pole_radius < widest ? pole_radius : widest;
  depth = pole * (1 - 0.69 * pole / widest);
  // The block's lower and upper end, and the points on the sphere.
  inner[] = {0.7 * pole, 0.4 * radius};
  outer[] = {pole, widest};
  outer_z[] = {-Sqrt(radius^2 - 2 * pole^2), widest};
  inner_z[] = {outer_z[0] + depth, 0.4 * radius};

  Include "cubed_sphere.geo";

  // Cells around, from the lowest point upwards, and from the block to the sphere. They grow upwards.
  around = 2 * Ceil(pole / pole_size - 1e-6);
  around = around * size < Acos(1 / 3) * radius ? Ceil(Acos(1 / 3) * radius / size - 1e-6) : around;
  length = (Pi - Asin(Sqrt(2) * widest / radius) - Asin(Sqrt(2) * pole / radius)) * radius;  // of an arc upwards
  mean = size > pole_size ? (size - pole_size) / Log(size / pole_size) : pole_size;
  upwards = Ceil(length / mean - 1e-6);
  growth = (size > pole_size ? size / pole_size : 1)^(1 / (upwards > 1 ? upwards - 1 : 1));
  outwards = Ceil(depth / pole_size - 1e-6);
  outwards = outwards * size < 0.6 * radius ? Ceil(0.6 * radius / size - 1e-6) : outwards;
  Transfinite Curve {1:8, 13:20} = around + 1;
  Transfinite Curve {9:12, 21:24} = upwards + 1 Using Progression growth;
  Transfinite Curve {25:32} = outwards + 1;
Else
  SetFactory("OpenCASCADE");
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
EndIf
