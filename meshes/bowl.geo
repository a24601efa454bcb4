// Bowl: a shell of revolution about z that stands on the plane z = 0 and opens upwards, elements in layers through
// its wall. Its outer profile is a flat foot, a wall that bends up in a circular arc, and a rounded rim that turns
// outwards.
DefineConstant[
  radius = {0.08, Min 0, Name "Bowl/1 Outer radius below the rim (m)"}
  foot = {0.03, Min 0, Name "Bowl/2 Radius of the flat foot (m)"}
  rim = {0.012, Min 0, Name "Bowl/3 Radius of the rim's profile (m)"}
  thickness = {0.007, Min 0, Name "Bowl/4 Thickness of the wall (m)"}
  size = {0.012, Min 0, Name "Bowl/5 Element size along the wall (m)"}
  layers = {1, Min 1, Step 1, Name "Bowl/6 Layers through the wall"}
  hexahedra = {0, Choices {0, 1}, Name "Bowl/7 Hexahedra instead of tetrahedra"}
];
If (radius <= 0 || foot <= 0 || rim <= 0 || thickness <= 0 || size <= 0)
  Error("radius, foot, rim, thickness and size must be above 0");
  Exit;
EndIf
If (layers < 1 || layers != Floor(layers))
  Error("layers must be a whole number, at least 1");
  Exit;
EndIf
If (hexahedra && thickness >= radius - foot)
  Error("thickness must be below radius - foot");
  Exit;
EndIf
If (radius <= foot)
  Error("radius must be above foot");
  Exit;
EndIf

bend = radius - foot;  // radius of the wall's arc
turn = 60 * Pi / 180;  // of the rim

If (hexahedra)
  around = Ceil(Pi / 2 * radius / size - 1e-6);  // cells in a quarter

  // The foot: a square on its corner with bent edges, whose angles suit the elements, and four parts around it.
  inner = 0.6 * foot;
  Point(1) = {0, 0, 0};
  For q In {0:3}
    Point(10 + q) = {foot * Cos(q * Pi / 2), foot * Sin(q * Pi / 2), 0};
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
  Transfinite Curve {30:33} = Ceil((foot - inner) / size - 1e-6) + 1;

  // Sections of wall and rim, arcs with their thickness.
  Point(40) = {foot, 0, bend};
  Point(41) = {foot, 0, thickness};
  Point(42) = {radius, 0, bend};
  Point(43) = {radius - thickness, 0, bend};
  Point(44) = {radius + rim, 0, bend};
  For k In {0:1}
    r = rim + k * thickness;
    Point(45 + k) = {radius + rim - r * Cos(turn), 0, bend + r * Sin(turn)};
  EndFor
  Circle(40) = {10, 40, 42};
  Circle(41) = {41, 40, 43};
  Line(42) = {10, 41};
  Line(43) = {42, 43};
  Circle(44) = {42, 44, 45};
  Circle(45) = {43, 44, 46};
  Line(46) = {45, 46};
  Curve Loop(6) = {40, 43, -41, -42};
  Plane Surface(6) = {6};
  Curve Loop(7) = {44, 46, -45, -43};
  Plane Surface(7) = {7};
  Transfinite Curve {40, 41} = Ceil(bend * Pi / 2 / size - 1e-6) + 1;
  Transfinite Curve {44, 45} = Ceil((rim + thickness / 2) * turn / size - 1e-6) + 1;
  Transfinite Curve {42, 43, 46} = layers + 1;
  Transfinite Surface {1:7};
  Recombine Surface {1:7};

  Extrude {0, 0, thickness} { Surface{1:5}; Layers{layers}; Recombine; }
  sections[] = {6, 7};
  For quarter In {1:4}
    wall[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Surface{sections[0]}; Layers{around}; Recombine; };
    lip[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Surface{sections[1]}; Layers{around}; Recombine; };
    sections[] = {wall[0], lip[0]};
  EndFor
  Coherence;
Else
  // The profile's points: their distance from the axis, and along it from the foot.
  r[] = {foot, foot, radius, radius + rim, radius + rim - rim * Cos(turn)};
  a[] = {0, bend, bend, bend, bend + rim * Sin(turn)};
  For i In {0:4}
    Point(i + 1) = {r[i], 0, a[i]};
  EndFor
  Circle(1) = {1, 2, 3};
  Circle(2) = {3, 4, 5};

  outer[] = {};
  edge[] = {};
  profile[] = {1, 2};
  For quarter In {1:4}
    wall[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Curve{profile[0]}; };
    lip[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Curve{profile[1]}; };
    profile[] = {wall[0], lip[0]};
    outer[] += {wall[1], lip[1]};
    edge[] += {-wall[3]};
  EndFor
  Coherence;
  Curve Loop(100) = {edge[]};
  Plane Surface(100) = {100};
  outer[] += {100};

  Extrude { Surface{outer[]}; Layers{layers, thickness}; }  // along the normals
EndIf
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;
Mesh.SecondOrderLinear = 1 - hexahedra;  // tetrahedra: gmsh knows no curved inner surface; straight edges on both sides

Physical Volume("body") = Volume{:};
