// Bell around z, its mouth in the plane z = 0: a wall of one thickness, tetrahedra in layers through it.
DefineConstant[
  thickness = {0.005, Min 0, Name "Bell/1 Thickness of the wall (m)"}
  size = {0.012, Min 0, Name "Bell/2 Element size along the wall (m)"}
  layers = {1, Min 1, Step 1, Name "Bell/3 Layers through the wall"}
];
If (thickness <= 0 || size <= 0 || layers < 1 || layers != Floor(layers))
  Error("thickness and size must be above 0, layers a whole number from 1 on");
  Exit;
EndIf
// The outer profile from the lip to the crown, m: a curve near these points, and a flat crown.
r[] = {0.064, 0.056, 0.047, 0.041, 0.0385, 0.036, 0.030, 0.012};
z[] = {0, 0.006, 0.022, 0.044, 0.062, 0.078, 0.086, 0.086};
last = 7;
For i In {0:last}
  Point(1 + i) = {r[i], 0, z[i]};
EndFor
BSpline(1) = {1:1 + last};
outer[] = {};
edge[] = {};
profile = 1;
For quarter In {1:4}
  wall[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Curve{profile}; };
  profile = wall[0];
  outer[] += {wall[1]};
  edge[] += {-wall[2]};
EndFor
Coherence;
Curve Loop(100) = {edge[]};
Plane Surface(100) = {100};
Extrude { Surface{outer[], 100}; Layers{layers, thickness}; }  // along the normals
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;
Mesh.SecondOrderLinear = 1;  // gmsh knows no curved inner surface; straight edges on both sides
Physical Volume("body") = Volume{:};
