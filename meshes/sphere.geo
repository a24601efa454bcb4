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
  // Corner i + 2 j + 4 k of the cube, 8 numbers on the one above it on the sphere.
  Point(1) = {0, 0, 0};
  For k In {0:1}
    For j In {0:1}
      For i In {0:1}
        corner = 2 + i + 2 * j + 4 * k;
        inner = 0.4 * radius;
        outer = radius / Sqrt(3);
        Point(corner) = {(2 * i - 1) * inner, (2 * j - 1) * inner, (2 * k - 1) * inner};
        Point(corner + 8) = {(2 * i - 1) * outer, (2 * j - 1) * outer, (2 * k - 1) * outer};
      EndFor
    EndFor
  EndFor

  // The cube's edges along x, y, z, 12 numbers on the arcs above them, and from 25 on the spokes between both.
  from[] = {0, 2, 4, 6, 0, 1, 4, 5, 0, 1, 2, 3};
  to[] = {1, 3, 5, 7, 2, 3, 6, 7, 4, 5, 6, 7};
  For corner In {0:7}
    Line(25 + corner) = {2 + corner, 10 + corner};
  EndFor
  For e In {0:11}
    Line(1 + e) = {2 + from[e], 2 + to[e]};
    Circle(13 + e) = {10 + from[e], 1, 10 + to[e]};
    Curve Loop(13 + e) = {1 + e, 25 + to[e], -(13 + e), -(25 + from[e])};
    Plane Surface(13 + e) = {13 + e};
  EndFor

  // The edges around each face of the cube; 6 numbers on the face on the sphere.
  edges[] = {5, 11, -7, -9, 6, 12, -8, -10, 1, 10, -3, -9, 2, 12, -4, -11, 1, 6, -2, -5, 3, 8, -4, -7};
  For f In {0:5}
    inside[] = {};
    outside[] = {};
    around[] = {};
    For e In {4 * f:4 * f + 3}
      sign = edges[e] > 0 ? 1 : -1;
      inside[] += {edges[e]};
      outside[] += {edges[e] + 12 * sign};
      around[] += {12 + Fabs(edges[e])};
    EndFor
    Curve Loop(1 + f) = {inside[]};
    Plane Surface(1 + f) = {1 + f};
    Curve Loop(7 + f) = {outside[]};
    Surface(7 + f) = {7 + f} In Sphere {1};
    Surface Loop(1 + f) = {1 + f, 7 + f, around[]};
    Volume(1 + f) = {1 + f};
  EndFor
  Surface Loop(7) = {1:6};
  Volume(7) = {7};

  Transfinite Curve {1:24} = Ceil(Acos(1 / 3) * radius / size - 1e-6) + 1;
  Transfinite Curve {25:32} = Ceil(0.5 * radius / size - 1e-6) + 1;
  Transfinite Surface {1:24};
  Recombine Surface {1:24};
  Transfinite Volume {1:7};

  Physical Volume("body") = {1:7};
  Physical Surface("surface") = {7:12};
Else
  SetFactory("OpenCASCADE");
  Sphere(1) = {0, 0, 0, radius};
  Mesh.Algorithm3D = 1; // Delaunay: HXT would make another mesh in each run
  Mesh.MeshSizeMin = size;
  Mesh.MeshSizeMax = size;

  Physical Volume("body") = {1};
  Physical Surface("surface") = Boundary{ Volume{1}; };
EndIf
