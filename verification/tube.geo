// Circular tube along x, from 0 to length: all of it, or its quarter y, z >= 0.
DefineConstant[
  length = {0.5, Min 0, Name "Tube/1 Length (m)"}
  outer = {0.0125, Min 0, Name "Tube/2 Outer radius (m)"}
  inner = {0.011, Min 0, Name "Tube/3 Inner radius (m)"}
  around = {6, Min 2, Step 1, Name "Tube/4 Elements around a quarter"}
  along = {50, Min 2, Step 1, Name "Tube/5 Elements along it"}
  layers = {1, Min 1, Step 1, Name "Tube/6 Layers across the wall"}
  quarters = {4, Choices {1, 4}, Name "Tube/7 Quarters"}
  hexahedra = {0, Choices {0, 1}, Name "Tube/8 Hexahedra instead of tetrahedra"}
];

Point(1) = {0, 0, 0};
body[] = {}; start[] = {}; end[] = {};
For q In {0:quarters - 1}
  angle = q * Pi / 2;
  p = newp;
  For k In {0:1}
    r = k ? outer : inner;
    Point(p + k) = {0, r * Cos(angle), r * Sin(angle)};
    Point(p + 2 + k) = {0, r * Cos(angle + Pi / 2), r * Sin(angle + Pi / 2)};
  EndFor
  l = newl;
  Line(l) = {p, p + 1};
  Circle(l + 1) = {p + 1, 1, p + 3};
  Line(l + 2) = {p + 3, p + 2};
  Circle(l + 3) = {p + 2, 1, p};
  Transfinite Curve {l, l + 2} = layers + 1;
  Transfinite Curve {l + 1, l + 3} = around + 1;
  s = news;
  Curve Loop(s) = {l:l + 3};
  Plane Surface(s) = {s};
  Transfinite Surface {s} Alternate;
  If (hexahedra)
    Recombine Surface {s};
    tube[] = Extrude {length, 0, 0} { Surface{s}; Layers{along}; Recombine; };
  Else
    tube[] = Extrude {length, 0, 0} { Surface{s}; Layers{along}; };
  EndIf
  body[] += {tube[1]}; start[] += {s}; end[] += {tube[0]};
EndFor
Coherence;

Physical Volume("body") = {body[]};
Physical Surface("start") = {start[]};  // x = 0
Physical Surface("end") = {end[]};      // x = length
If (quarters == 1)
  Physical Surface("middle_z") = {tube[2]};  // z = 0
  Physical Surface("middle_y") = {tube[4]};  // y = 0
EndIf
