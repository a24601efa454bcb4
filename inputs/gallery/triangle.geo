// Triangle: a round rod, bent twice and open at the third corner, in the plane y = 0.
SetFactory("OpenCASCADE");
DefineConstant[
  side = {0.15, Min 0, Name "Triangle/1 Side (m)"}
  diameter = {0.008, Min 0, Name "Triangle/2 Diameter of the rod (m)"}
  bend = {0.015, Min 0, Name "Triangle/3 Radius of the bends (m)"}
  size = {0.007, Min 0, Name "Triangle/4 Element size (m)"}
];
If (side <= 0 || diameter <= 0 || bend <= diameter / 2 || size <= 0 || bend > side / 4)
  Error("side, diameter and size must be above 0, bend between half the diameter and a quarter of the side");
  Exit;
EndIf
// Corners A (open, left below), B (above), C (right below). A bend by 120 degrees takes `cut` of each side.
cut = bend * Tan(60 * Pi / 180);
h = side * Sin(60 * Pi / 180);
ux = 0.5; uz = Sin(60 * Pi / 180);      // from A to B
Point(1) = {0, 0, 0};
Point(2) = {(side - cut) * ux, 0, (side - cut) * uz};
Point(3) = {side / 2 + cut * ux, 0, h - cut * uz};
Point(4) = {side - cut * ux, 0, cut * uz};
Point(5) = {side - cut, 0, 0};
Point(6) = {0.1 * side, 0, 0};
Point(7) = {side / 2, 0, h - bend / Sin(30 * Pi / 180)};
Point(8) = {side - bend / Tan(30 * Pi / 180), 0, bend};
Line(1) = {1, 2};
Circle(2) = {2, 7, 3};
Line(3) = {3, 4};
Circle(4) = {4, 8, 5};
Line(5) = {5, 6};
Wire(1) = {1:5};
Disk(1) = {0, 0, 0, diameter / 2};
Rotate {{0, 1, 0}, {0, 0, 0}, Pi / 6} { Surface{1}; }
Extrude { Surface{1}; } Using Wire {1}
Delete { Surface{1}; }
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;
Physical Volume("body") = Volume{:};
