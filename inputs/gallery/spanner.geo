// Open-ended spanner along x in the plane z = 0, centred; `thickness` upwards.
SetFactory("OpenCASCADE");
DefineConstant[
  length = {0.2, Min 0, Name "Spanner/1 Distance of the heads (m)"}
  handle = {0.02, Min 0, Name "Spanner/2 Width of the handle (m)"}
  head = {0.022, Min 0, Name "Spanner/3 Radius of a head (m)"}
  jaw = {0.019, Min 0, Name "Spanner/4 Width of a jaw (m)"}
  thickness = {0.007, Min 0, Name "Spanner/5 Thickness (m)"}
  size = {0.012, Min 0, Name "Spanner/6 Element size (m)"}
];
If (length <= 0 || handle <= 0 || head <= handle / 2 || jaw <= 0 || jaw >= 2 * head || thickness <= 0 || size <= 0)
  Error("lengths must be above 0, head above half the handle, jaw below the diameter of the head");
  Exit;
EndIf
Cylinder(1) = {-length / 2, 0, 0, 0, 0, thickness, head};
Cylinder(2) = {length / 2, 0, 0, 0, 0, thickness, head};
Box(3) = {-length / 2, -handle / 2, 0, length, handle, thickness};
BooleanUnion(4) = { Volume{1}; Delete; }{ Volume{2, 3}; Delete; };
Box(5) = {-length / 2 - 2 * head, -jaw / 2, -thickness, 2 * head, jaw, 3 * thickness};
Box(6) = {length / 2, -jaw / 2, -thickness, 2 * head, jaw, 3 * thickness};
BooleanDifference(7) = { Volume{4}; Delete; }{ Volume{5, 6}; Delete; };
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;
Physical Volume("body") = Volume{:};
