// Tuning fork: two tines along z from z = 0 to z = length, a bridge between them below, and a stem below the bridge. The
// tines swing along x; everything is `width` wide along y, centred. The stem is as thick as the gap.
DefineConstant[
  length = {0.09, Min 0, Name "Tuning fork/1 Length of the tines (m)"}
  thickness = {0.004, Min 0, Name "Tuning fork/2 Thickness of a tine (m)"}
  gap = {0.008, Min 0, Name "Tuning fork/3 Gap between the tines (m)"}
  width = {0.006, Min 0, Name "Tuning fork/4 Width (m)"}
  bridge = {0.008, Min 0, Name "Tuning fork/5 Height of the bridge (m)"}
  stem = {0.04, Min 0, Name "Tuning fork/6 Length of the stem (m)"}
  size = {0.01, Min 0, Name "Tuning fork/7 Element size (m)"}
  hexahedra = {0, Choices {0, 1}, Name "Tuning fork/8 Hexahedra instead of tetrahedra"}
];
If (length <= 0 || thickness <= 0 || gap <= 0 || width <= 0 || bridge <= 0 || stem <= 0 || size <= 0)
  Error("length, thickness, gap, width, bridge, stem and size must be above 0");
  Exit;
EndIf

// Points at four x and four z; lines along x (100 + 10 row + column) and along z (200 + 10 row + column) between them.
x[] = {-gap / 2 - thickness, -gap / 2, gap / 2, gap / 2 + thickness};
z[] = {-bridge - stem, -bridge, 0, length};
For row In {0:3}
  For column In {0:3}
    If (row > 0 || column == 1 || column == 2)
      Point(1 + 4 * row + column) = {x[column], -width / 2, z[row]};
    EndIf
  EndFor
EndFor
along_x[] = {1, 10, 11, 12, 20, 21, 22, 30, 32};
along_z[] = {1, 2, 10, 11, 12, 13, 20, 21, 22, 23};
For i In {0:#along_x[] - 1}
  row = Floor(along_x[i] / 10);
  column = along_x[i] - 10 * row;
  Line(100 + along_x[i]) = {1 + 4 * row + column, 2 + 4 * row + column};
  Transfinite Curve {100 + along_x[i]} = Ceil((x[column + 1] - x[column]) / size - 1e-6) + 1;
EndFor
For i In {0:#along_z[] - 1}
  row = Floor(along_z[i] / 10);
  column = along_z[i] - 10 * row;
  Line(200 + along_z[i]) = {1 + 4 * row + column, 5 + 4 * row + column};
  Transfinite Curve {200 + along_z[i]} = Ceil((z[row + 1] - z[row]) / size - 1e-6) + 1;
EndFor

blocks[] = {1, 10, 11, 12, 20, 22};  // stem; left, middle and right of the bridge; left and right tine
volumes[] = {};
For i In {0:5}
  block = blocks[i];
  Curve Loop(block) = {100 + block, 201 + block, -(110 + block), -(200 + block)};
  Plane Surface(block) = {block};
  Transfinite Surface {block};
  If (hexahedra)
    Recombine Surface {block};
    solid[] = Extrude {0, width, 0} { Surface{block}; Layers{Ceil(width / size - 1e-6)}; Recombine; };
  Else
    solid[] = Extrude {0, width, 0} { Surface{block}; Layers{Ceil(width / size - 1e-6)}; };
  EndIf
  volumes[] += {solid[1]};
  If (i == 0)
    foot = solid[2];
  EndIf
EndFor
Coherence;  // the sides between the blocks were made twice

Physical Volume("body") = {volumes[]};
Physical Surface("foot") = {foot};
