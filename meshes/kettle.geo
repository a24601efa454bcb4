// Kettle of a drum: a cylinder along z, closed below by a half ellipsoid or, without one, by a flat bottom. The drum head
// lies in the plane z = 0. The kettle ends a little above it, so that no air passes at the rim.
SetFactory("OpenCASCADE");
DefineConstant[
  radius = {0.328, Min 0, Name "Kettle/1 Inner radius (m)"}
  straight = {0.24, Min 0, Name "Kettle/2 Depth of the cylinder (m)"}
  bowl = {0.26, Min 0, Name "Kettle/3 Depth of the half ellipsoid, 0 for a flat bottom (m)"}
  wall = {0.006, Min 0, Name "Kettle/4 Thickness of the wall (m)"}
  lip = {0.002, Min 0, Name "Kettle/5 Height above the head (m)"}
  size = {0.03, Min 0, Name "Kettle/6 Largest element (m)"}
];
If (radius <= 0 || straight <= 0 || bowl < 0 || wall <= 0 || lip <= 0 || size <= 0)
  Error("radius, straight, wall, lip and size must be above 0, bowl at least 0");
  Exit;
EndIf
depth = straight + (bowl == 0 ? wall : 0);
Cylinder(1) = {0, 0, -depth, 0, 0, depth + lip, radius + wall};
Cylinder(2) = {0, 0, -straight, 0, 0, straight + 2 * lip, radius};
If (bowl > 0)
  Sphere(3) = {0, 0, -straight, 1, -Pi / 2, 0};
  Sphere(4) = {0, 0, -straight, 1, -Pi / 2, 0};
  Dilate {{0, 0, -straight}, {radius + wall, radius + wall, bowl + wall}} { Volume{3}; }
  Dilate {{0, 0, -straight}, {radius, radius, bowl}} { Volume{4}; }
  outside() = BooleanUnion{ Volume{1}; Delete; }{ Volume{3}; Delete; };
  inside() = BooleanUnion{ Volume{2}; Delete; }{ Volume{4}; Delete; };
Else
  outside() = {1};
  inside() = {2};
EndIf
BooleanDifference{ Volume{outside()}; Delete; }{ Volume{inside()}; Delete; }
Mesh.MeshSizeMax = size;
Mesh.MeshSizeMin = size;
Physical Volume("body") = Volume{:};
