// Bowl: a shell of revolution about z that stands on the plane z = 0 and opens upwards, elements in layers through
// its wall. Its outer profile is a flat foot, a wall that bends up in a circular arc, and a rounded rim that turns
// outwards.
DefineConstant[
  radius = {0.08, Min 0, Name "Bowl/1 Outer radius below the rim (m)"}
  foot = {0.03, Min 0, Name "Bowl/2 Radius of the flat foot (m)"}
  rim = {0.012, Min 0, Name "Bowl/3 Radius of the rim's profile (m)"}
  thickness = {0.007, Min 0, Name "Bowl/4 Thickness of the wall (m)"}
  size = {0.012, Min 0, Name "Bowl/5 Element size along the wall (m)"}
  layers = {1, Min 1, Step 1, Name "Bowl/6 Layers through the wall"}
];
If (radius <= 0 || foot <= 0 || rim <= 0 || thickness <= 0 || size <= 0)
  Error("radius, foot, rim, thickness and size must be above 0");
  Exit;
EndIf
If (layers < 1 || layers != Floor(layers))
  Error("layers must be a whole number, at least 1");
  Exit;
EndIf
If (radius <= foot)
  Error("radius must be above foot");
  Exit;
EndIf

bend = radius - foot;  // radius of the wall's arc
turn = 60 * Pi / 180;  // of the rim

// The profile's points: their distance from the axis, and along it from the foot.
r[] = {foot, foot, radius, radius + rim, radius + rim - rim * Cos(turn)};
a[] = {0, bend, bend, bend, bend + rim * Sin(turn)};
For i In {0:4}
  Point(i + 1) = {r[i], 0, a[i]};
EndFor
Circle(1) = {1, 2, 3};
Circle(2) = {3, 4, 5};

outer[] = {};
edge[] = {};
profile[] = {1, 2};
For quarter In {1:4}
  wall[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Curve{profile[0]}; };
  lip[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Curve{profile[1]}; };
  profile[] = {wall[0], lip[0]};
  outer[] += {wall[1], lip[1]};
  edge[] += {-wall[3]};
EndFor
Coherence;
Curve Loop(100) = {edge[]};
Plane Surface(100) = {100};
outer[] += {100};

Extrude { Surface{outer[]}; Layers{layers, thickness}; }  // along the normals
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;
Mesh.SecondOrderLinear = 1;  // gmsh knows no curved inner surface: straight edges on both sides

Physical Volume("body") = Volume{:};
