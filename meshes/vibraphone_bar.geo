// Vibraphone bar along x, centred in x and y, its top in the plane z = 0. Its underside is an arch: the bar is
// centre + (thickness - centre) (|x|/arch)^power thick where |x| < arch, and `thickness` thick beyond. With aluminium of
// 70 GPa, 2700 kg/m3 and Poisson's ratio 0.33 the defaults tune the first three bending modes to 187, 748 and 1870 Hz.
DefineConstant[
  length = {0.36, Min 0, Name "Vibraphone bar/1 Length (m)"}
  width = {0.05, Min 0, Name "Vibraphone bar/2 Width (m)"}
  thickness = {0.013, Min 0, Name "Vibraphone bar/3 Thickness of the ends (m)"}
  centre = {0.00495, Min 0, Name "Vibraphone bar/4 Thickness in the middle (m)"}
  arch = {0.0991, Min 0, Name "Vibraphone bar/5 Half the length of the arch (m)"}
  power = {3.19, Min 0, Name "Vibraphone bar/6 Shape of the arch"}
  size = {0.01, Min 0, Name "Vibraphone bar/7 Element size along and across the bar (m)"}
  layers = {1, Min 1, Step 1, Name "Vibraphone bar/8 Layers across the thickness"}
  hexahedra = {0, Choices {0, 1}, Name "Vibraphone bar/9 Hexahedra instead of tetrahedra"}
];
If (length <= 0 || width <= 0 || thickness <= 0 || centre <= 0 || arch <= 0 || power <= 0 || size <= 0)
  Error("length, width, thickness, centre, arch, power and size must be above 0");
  Exit;
EndIf
If (layers < 1 || layers != Floor(layers))
  Error("layers must be a whole number, at least 1");
  Exit;
EndIf

If (hexahedra)
  // Three parts, so that the arch begins and ends between cells.
  x[] = {-length / 2, -arch, arch, length / 2};
  For i In {0:3}
    Point(1 + i) = {x[i], -width / 2, -thickness};
    Point(5 + i) = {x[i], -width / 2, 0};
    Line(7 + i) = {1 + i, 5 + i};
  EndFor
  points = 80;
  underside[] = {2};
  For i In {1:points - 1}
    s = 2 * i / points - 1;
    Point(10 + i) = {s * arch, -width / 2, -centre - (thickness - centre) * Fabs(s)^power};
    underside[] += {10 + i};
  EndFor
  underside[] += {3};
  Line(1) = {1, 2};
  Spline(2) = {underside[]};
  Line(3) = {3, 4};
  volumes[] = {}; below[] = {}; above[] = {};
  For i In {0:2}
    Line(4 + i) = {5 + i, 6 + i};
    Transfinite Curve {1 + i, 4 + i} = Ceil((x[i + 1] - x[i]) / size - 1e-6) + 1;
  EndFor
  Transfinite Curve {7:10} = layers + 1;
  For i In {0:2}
    Curve Loop(1 + i) = {1 + i, 8 + i, -(4 + i), -(7 + i)};
    Plane Surface(1 + i) = {1 + i};
    Transfinite Surface {1 + i};
    Recombine Surface {1 + i};
    bar[] = Extrude {0, width, 0} { Surface{1 + i}; Layers{Ceil(width / size - 1e-6)}; Recombine; };
    volumes[] += {bar[1]}; below[] += {bar[2]}; above[] += {bar[4]};
  EndFor
  Coherence;  // the sides between the parts were made twice
Else
  along = 2 * Ceil(length / (2 * size) - 1e-6);
  across = 2 * Ceil(width / (2 * size) - 1e-6);
  underside[] = {};
  For i In {0:along}
    x = (i / along - 0.5) * length;
    within = Fabs(x) < arch ? Fabs(x) / arch : 1;
    Point(i + 1) = {x, -width / 2, -centre - (thickness - centre) * within^power};
    underside[] += {i + 1};
  EndFor
  Point(along + 2) = {length / 2, -width / 2, 0};
  Point(along + 3) = {-length / 2, -width / 2, 0};
  Spline(1) = {underside[]};
  Line(2) = {along + 1, along + 2};
  Line(3) = {along + 2, along + 3};
  Line(4) = {along + 3, 1};
  Curve Loop(1) = {1:4};
  Plane Surface(1) = {1};
  Transfinite Curve {1, 3} = along + 1;
  Transfinite Curve {2, 4} = layers + 1;
  Transfinite Surface {1} Alternate;

  bar[] = Extrude {0, width, 0} { Surface{1}; Layers{across}; };
  volumes[] = {bar[1]}; below[] = {bar[2]}; above[] = {bar[4]};
EndIf

Physical Volume("body") = {volumes[]};
Physical Surface("underside") = {below[]};
Physical Surface("top") = {above[]};
