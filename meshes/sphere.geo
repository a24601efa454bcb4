// Solid sphere, centred at the origin; its poles, above and below the centre, are nodes (of hexahedra if their number
// along an edge, or their order, is even). Hexahedra make a cube and six caps between its faces and the sphere.
DefineConstant[
  radius = {0.05, Min 0, Name "Sphere/1 Radius (m)"}
  size = {0.02, Min 0, Name "Sphere/2 Element size (m)"}
  hexahedra = {0, Choices {0, 1}, Name "Sphere/3 Hexahedra instead of tetrahedra"}
];
If (radius <= 0 || size <= 0)
  Error("radius and size must be above 0");
  Exit;
EndIf

If (hexahedra)
  SetFactory("Built-in");
  inner[] = {0.4 * radius, 0.4 * radius};
  inner_z[] = {-0.4 * radius, 0.4 * radius};
  outer[] = {radius / Sqrt(3), radius / Sqrt(3)};
  outer_z[] = {-radius / Sqrt(3), radius / Sqrt(3)};
  Include "cubed_sphere.geo";
  Transfinite Curve {1:24} = Ceil(Acos(1 / 3) * radius / size - 1e-6) + 1;
  Transfinite Curve {25:32} = Ceil(0.5 * radius / size - 1e-6) + 1;
Else
  SetFactory("OpenCASCADE");
  Sphere(1) = {0, 0, 0, radius};
  Mesh.Algorithm3D = 1; // Delaunay: HXT would make another mesh in each run
  Mesh.MeshSizeMin = size;
  Mesh.MeshSizeMax = size;

  Physical Volume("body") = {1};
  Physical Surface("surface") = Boundary{ Volume{1}; };
EndIf
