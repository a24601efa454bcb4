// Vase: a shell of revolution about z that stands on the plane z = 0, tetrahedra in layers through its wall.
DefineConstant[
  foot = {0.035, Min 0, Name "Vase/1 Radius of the foot (m)"}
  belly = {0.06, Min 0, Name "Vase/2 Largest radius (m)"}
  neck = {0.028, Min 0, Name "Vase/3 Smallest radius (m)"}
  lip = {0.04, Min 0, Name "Vase/4 Radius of the lip (m)"}
  height = {0.2, Min 0, Name "Vase/5 Height (m)"}
  thickness = {0.005, Min 0, Name "Vase/6 Thickness of the wall (m)"}
  size = {0.014, Min 0, Name "Vase/7 Element size along the wall (m)"}
  layers = {1, Min 1, Step 1, Name "Vase/8 Layers through the wall"}
];
If (foot <= 0 || belly <= 0 || neck <= 0 || lip <= 0 || height <= 0 || thickness <= 0 || size <= 0)
  Error("all lengths must be above 0");
  Exit;
EndIf
If (layers < 1 || layers != Floor(layers))
  Error("layers must be a whole number, at least 1");
  Exit;
EndIf

// The outer profile, from the foot to the lip.
Point(1) = {foot, 0, 0};
Point(2) = {belly, 0, 0.4 * height};
Point(3) = {neck, 0, 0.85 * height};
Point(4) = {lip, 0, height};
Spline(1) = {1:4};

outer[] = {};
edge[] = {};
profile = 1;
For quarter In {1:4}
  wall[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Curve{profile}; };
  profile = wall[0];
  outer[] += {wall[1]};
  edge[] += {-wall[3]};
EndFor
Coherence;
Curve Loop(100) = {edge[]};
Plane Surface(100) = {100};
outer[] += {100};

Extrude { Surface{outer[]}; Layers{layers, thickness}; }  // along the normals
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;

Physical Volume("body") = Volume{:};
