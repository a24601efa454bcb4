// Circular plate, centred at the origin, z in [-thickness/2, thickness/2]: all of it, or its quarter x, y >= 0.
DefineConstant[
  radius = {0.15, Min 0, Name "Disc/1 Radius (m)"}
  thickness = {0.003, Min 0, Name "Disc/2 Thickness (m)"}
  size = {0.01, Min 0, Name "Disc/3 In-plane element size (m)"}
  rim_size = {0.01, Min 0, Name "Disc/4 In-plane element size at the rim (m)"}
  layers = {1, Min 1, Step 1, Name "Disc/5 Layers across the thickness"}
  quarters = {4, Choices {1, 4}, Name "Disc/6 Quarters"}
  hexahedra = {0, Choices {0, 1}, Name "Disc/7 Hexahedra instead of tetrahedra"}
];

z = -thickness / 2;
volumes[] = {}; rim[] = {}; middle_y[] = {}; middle_x[] = {};
If (hexahedra)
  // Each quarter: a square at the centre, bent outwards, and two parts between it and the rim.
  around = Ceil(Pi / 4 * radius / size - 1e-6);  // cells in an eighth
  radial = Ceil(radius / (size + rim_size) - 1e-6);
  Geometry.AutoCoherence = 0;  // would take away curves that the next part needs
  growth = (rim_size / size)^(1 / (radial > 1 ? radial - 1 : 1));  // of a cell over the one within
  For q In {0:quarters - 1}
    c = Cos(q * Pi / 2); s = Sin(q * Pi / 2);
    // In the first quarter: the centre, the square's other corners, and three points of the rim.
    x[] = {0, radius / 2, 0.4 * radius, 0, radius, radius * Cos(Pi / 4), 0};
    y[] = {0, 0, 0.4 * radius, radius / 2, 0, radius * Sin(Pi / 4), radius};
    p = newp;
    For i In {0:6}
      Point(p + i) = {c * x[i] - s * y[i], s * x[i] + c * y[i], z};
    EndFor
    l = newl;
    Line(l) = {p, p + 1};
    Line(l + 1) = {p + 1, p + 2};
    Line(l + 2) = {p + 2, p + 3};
    Line(l + 3) = {p + 3, p};
    Circle(l + 4) = {p + 4, p, p + 5};
    Circle(l + 5) = {p + 5, p, p + 6};
    Line(l + 6) = {p + 1, p + 4};
    Line(l + 7) = {p + 2, p + 5};
    Line(l + 8) = {p + 3, p + 6};
    Transfinite Curve {l:l + 5} = around + 1;
    Transfinite Curve {l + 6:l + 8} = radial + 1 Using Progression growth;
    f = news;
    Curve Loop(f) = {l:l + 3};
    Curve Loop(f + 1) = {l + 6, l + 4, -(l + 7), -(l + 1)};
    Curve Loop(f + 2) = {l + 7, l + 5, -(l + 8), -(l + 2)};
    For i In {0:2}
      Plane Surface(f + i) = {f + i};
      Transfinite Surface {f + i};
      Recombine Surface {f + i};
      part[] = Extrude {0, 0, thickness} { Surface{f + i}; Layers{layers}; Recombine; };
      volumes[] += {part[1]};
      If (i == 0)
        middle_y[] += {part[2]}; middle_x[] += {part[5]};
      ElseIf (i == 1)
        middle_y[] += {part[2]}; rim[] += {part[3]};
      Else
        rim[] += {part[3]}; middle_x[] += {part[4]};
      EndIf
    EndFor
  EndFor
  Coherence;
Else
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
  volumes[] = {plate[1]};
  If (quarters == 1)
    middle_y[] = {plate[2]}; rim[] = {plate[3]}; middle_x[] = {plate[4]};
  Else
    rim[] = {plate[2], plate[3], plate[4], plate[5]};
  EndIf
EndIf

Physical Volume("body") = {volumes[]};
Physical Surface("rim") = {rim[]};
If (quarters == 1)
  Physical Surface("middle_y") = {middle_y[]};  // y = 0
  Physical Surface("middle_x") = {middle_x[]};  // x = 0
EndIf
