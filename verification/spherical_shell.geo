// Middle surface of a spherical shell, centred at the origin: a cube's faces, blown up.
DefineConstant[
  radius = {0.1, Min 0, Name "Shell/1 Radius (m)"}
  cells = {3, Min 1, Step 1, Name "Shell/2 Cells along an edge of the cube"}
];

Point(1) = {0, 0, 0};
a = radius / Sqrt(3);
z[] = {-a, a};
For k In {0:1}
  p = 2 + 4 * k;
  Point(p) = {-a, -a, z[k]}; Point(p + 1) = {a, -a, z[k]}; Point(p + 2) = {a, a, z[k]}; Point(p + 3) = {-a, a, z[k]};
EndFor
For i In {0:3}
  next = (i + 1) % 4;
  Circle(1 + i) = {2 + i, 1, 2 + next};   // below
  Circle(5 + i) = {6 + i, 1, 6 + next};   // above
  Circle(9 + i) = {2 + i, 1, 6 + i};      // upwards
EndFor
For i In {0:3}
  Curve Loop(1 + i) = {1 + i, 9 + (i + 1) % 4, -(5 + i), -(9 + i)};
EndFor
Curve Loop(5) = {1:4};
Curve Loop(6) = {5:8};
For f In {1:6}
  Surface(f) = {f} In Sphere {1};
EndFor

Transfinite Curve {1:12} = cells + 1;
Transfinite Surface {1:6};
Recombine Surface {1:6};
Physical Surface("body") = {1:6};
