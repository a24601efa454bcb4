// Disc about z, its underside in the plane z = 0: a square with bent edges in the middle and four parts around it.
DefineConstant[
  radius = {0.019, Min 0, Name "Disc/1 Radius (m)"}
  thickness = {0.0028, Min 0, Name "Disc/2 Thickness (m)"}
  around = {2, Min 1, Step 1, Name "Disc/3 Cells around a quarter"}
  hexahedra = {1, Choices {0, 1}, Name "Disc/4 Hexahedra"}
];
If (radius <= 0 || thickness <= 0 || around < 1 || around != Floor(around))
  Error("radius and thickness must be above 0, around a whole number from 1 on");
  Exit;
EndIf
inner = 0.55 * radius;
Point(1) = {0, 0, 0};
For q In {0:3}
  Point(10 + q) = {radius * Cos(q * Pi / 2), radius * Sin(q * Pi / 2), 0};
  Point(20 + q) = {inner * Cos(q * Pi / 2), inner * Sin(q * Pi / 2), 0};
  Point(30 + q) = {-inner * Cos((q + 0.5) * Pi / 2), -inner * Sin((q + 0.5) * Pi / 2), 0};
EndFor
For q In {0:3}
  next = (q + 1) % 4;
  Circle(10 + q) = {10 + q, 1, 10 + next};
  Circle(20 + q) = {20 + q, 30 + q, 20 + next};
  Line(30 + q) = {20 + q, 10 + q};
EndFor
For q In {0:3}
  Curve Loop(1 + q) = {30 + q, 10 + q, -(30 + (q + 1) % 4), -(20 + q)};
  Plane Surface(1 + q) = {1 + q};
EndFor
Curve Loop(5) = {20:23};
Plane Surface(5) = {5};
Transfinite Curve {10:13, 20:23} = around + 1;
Transfinite Curve {30:33} = Ceil(around / 2) + 1;
Transfinite Surface {1:5};
Recombine Surface {1:5};
Extrude {0, 0, thickness} { Surface{1:5}; Layers{1}; Recombine; }
Physical Volume("body") = Volume{:};
