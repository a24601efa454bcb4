// Round string along x: x in [0, length]. Its cross-section is a square with bent edges in the middle and four parts
// around it. The elements' direction of the thickness is that of x.
DefineConstant[
  length = {0.65, Min 0, Name "String/1 Length (m)"}
  radius = {0.00025, Min 0, Name "String/2 Radius (m)"}
  cells = {14, Min 1, Step 1, Name "String/3 Cells along the string, beside two at each end"}
  hexahedra = {1, Choices {0, 1}, Name "String/4 Hexahedra"}
];
If (length <= 0 || radius <= 0 || cells < 1 || cells != Floor(cells))
  Error("length and radius must be above 0, cells a whole number from 1 on");
  Exit;
EndIf
inner = 0.55 * radius;
Point(1) = {0, 0, 0};
For q In {0:3}
  Point(10 + q) = {0, radius * Cos(q * Pi / 2), radius * Sin(q * Pi / 2)};
  Point(20 + q) = {0, inner * Cos(q * Pi / 2), inner * Sin(q * Pi / 2)};
  Point(30 + q) = {0, -inner * Cos((q + 0.5) * Pi / 2), -inner * Sin((q + 0.5) * Pi / 2)};
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
Transfinite Curve {10:13, 20:23, 30:33} = 2;
Transfinite Surface {1:5};
Recombine Surface {1:5};
// The string bends near its ends, in cells of their own.
Extrude {length, 0, 0} { Surface{1:5}; Layers{ {1, 1, cells, 1, 1}, {0.01, 0.03, 0.97, 0.99, 1} }; Recombine; }
Physical Volume("body") = Volume{:};
e = radius / 1000;
left[] = Surface In BoundingBox{-e, -1, -1, e, 1, 1};
right[] = Surface In BoundingBox{length - e, -1, -1, length + e, 1, 1};
Physical Surface("ends") = {left[], right[]};
Physical Surface("left") = {left[]};
Physical Surface("right") = {right[]};
