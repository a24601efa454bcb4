// Circular plate, centred at the origin, z in [-thickness/2, thickness/2]: all of it, or its quarter x, y >= 0.
DefineConstant[
  radius = {0.15, Min 0, Name "Disc/1 Radius (m)"}
  thickness = {0.003, Min 0, Name "Disc/2 Thickness (m)"}
  size = {0.01, Min 0, Name "Disc/3 In-plane element size (m)"}
  rim_size = {0.01, Min 0, Name "Disc/4 In-plane element size at the rim (m)"}
  layers = {1, Min 1, Step 1, Name "Disc/5 Layers across the thickness"}
  quarters = {4, Choices {1, 4}, Name "Disc/6 Quarters"}
];

z = -thickness / 2;
Point(1) = {0, 0, z, size};
For q In {0:3}
  Point(2 + q) = {radius * Cos(q * Pi / 2), radius * Sin(q * Pi / 2), z, rim_size};
EndFor
If (quarters == 1)
  Line(1) = {1, 2};
  Circle(2) = {2, 1, 3};
  Line(3) = {3, 1};
  Curve Loop(1) = {1:3};
Else
  For q In {0:3}
    Circle(1 + q) = {2 + q, 1, 2 + (q + 1) % 4};
  EndFor
  Curve Loop(1) = {1:4};
EndIf
Plane Surface(1) = {1};
If (quarters == 4)
  Point{1} In Surface{1};
EndIf

plate[] = Extrude {0, 0, thickness} { Surface{1}; Layers{layers}; };

Physical Volume("body") = {plate[1]};
If (quarters == 1)
  Physical Surface("middle_y") = {plate[2]};  // y = 0
  Physical Surface("rim") = {plate[3]};
  Physical Surface("middle_x") = {plate[4]};  // x = 0
Else
  Physical Surface("rim") = {plate[2], plate[3], plate[4], plate[5]};
EndIf
