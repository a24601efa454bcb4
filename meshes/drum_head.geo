// Drum head in the plane z = 0: the middle surface for a body with a `thickness`. A square with bent edges in the middle,
// four parts around it, and a narrow ring at the rim, within which a film bends.
DefineConstant[
  radius = {0.15, Min 0, Name "Drum head/1 Radius (m)"}
  ring = {0.005, Min 0, Name "Drum head/2 Width of the ring at the rim (m)"}
  around = {3, Min 1, Step 1, Name "Drum head/3 Cells around a quarter"}
];
If (radius <= 0 || ring <= 0 || ring > 0.2 * radius || around < 1 || around != Floor(around))
  Error("radius and ring must be above 0, ring at most 0.2 radius, around a whole number from 1 on");
  Exit;
EndIf
inner = 0.55 * radius;
Point(1) = {0, 0, 0};
For q In {0:3}
  c = Cos(q * Pi / 2);
  s = Sin(q * Pi / 2);
  Point(10 + q) = {radius * c, radius * s, 0};
  Point(20 + q) = {(radius - ring) * c, (radius - ring) * s, 0};
  Point(30 + q) = {inner * c, inner * s, 0};
  Point(40 + q) = {-inner * Cos((q + 0.5) * Pi / 2), -inner * Sin((q + 0.5) * Pi / 2), 0};
EndFor
For q In {0:3}
  next = (q + 1) % 4;
  Circle(10 + q) = {10 + q, 1, 10 + next};
  Circle(20 + q) = {20 + q, 1, 20 + next};
  Circle(30 + q) = {30 + q, 40 + q, 30 + next};
  Line(40 + q) = {20 + q, 10 + q};
  Line(50 + q) = {30 + q, 20 + q};
EndFor
For q In {0:3}
  next = (q + 1) % 4;
  Curve Loop(1 + q) = {40 + q, 10 + q, -(40 + next), -(20 + q)};
  Plane Surface(1 + q) = {1 + q};
  Curve Loop(5 + q) = {50 + q, 20 + q, -(50 + next), -(30 + q)};
  Plane Surface(5 + q) = {5 + q};
EndFor
Curve Loop(9) = {30:33};
Plane Surface(9) = {9};
Transfinite Curve {10:13, 20:23, 30:33} = around + 1;
Transfinite Curve {40:43} = 2;
Transfinite Curve {50:53} = Ceil(around / 2) + 1;
Transfinite Surface {1:9};
Recombine Surface {1:9};
Physical Surface("body") = Surface{:};
Physical Curve("rim") = {10:13};
