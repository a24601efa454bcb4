// Tuning fork in the plane y = 0, its prongs along z, its stem below. The stem's end is the group `stem`.
DefineConstant[
  length = {0.0925, Min 0, Name "Tuning fork/1 Length of the prongs (m)"}
  prong = {0.0045, Min 0, Name "Tuning fork/2 Thickness of the prongs (m)"}
  gap = {0.008, Min 0, Name "Tuning fork/3 Distance of the prongs (m)"}
  base = {0.007, Min 0, Name "Tuning fork/4 Height of the base (m)"}
  stem = {0.03, Min 0, Name "Tuning fork/5 Length of the stem (m)"}
  width = {0.006, Min 0, Name "Tuning fork/6 Width (m)"}
  cells = {6, Min 1, Step 1, Name "Tuning fork/7 Cells along a prong"}
  hexahedra = {1, Choices {0, 1}, Name "Tuning fork/8 Hexahedra"}
];
If (length <= 0 || prong <= 0 || gap <= 0 || base <= 0 || stem <= 0 || width <= 0)
  Error("length, prong, gap, base, stem and width must be above 0");
  Exit;
EndIf
If (cells < 1 || cells != Floor(cells))
  Error("cells must be a whole number, at least 1");
  Exit;
EndIf
// Columns: prong, gap, prong. Rows: stem, base, prongs.
x[] = {-gap / 2 - prong, -gap / 2, gap / 2, gap / 2 + prong};
z[] = {-base - stem, -base, 0, length};
For i In {0:3}
  For j In {0:3}
    Point(1 + 4 * j + i) = {x[i], -width / 2, z[j]};
  EndFor
EndFor
// Of each cell of the grid that is filled: column, row.
column[] = {1, 0, 1, 2, 0, 2};
row[] = {0, 1, 1, 1, 2, 2};
For i In {0:2}
  For j In {0:3}
    Line(101 + 4 * j + i) = {1 + 4 * j + i, 2 + 4 * j + i};  // along x
    Transfinite Curve {101 + 4 * j + i} = 2;
  EndFor
EndFor
For j In {0:2}
  For i In {0:3}
    Line(201 + 4 * j + i) = {1 + 4 * j + i, 5 + 4 * j + i};  // along z
    Transfinite Curve {201 + 4 * j + i} = j == 0 ? 4 : (j == 1 ? 2 : cells + 1);
  EndFor
EndFor
For c In {0:5}
  i = column[c];
  j = row[c];
  Curve Loop(1 + c) = {101 + 4 * j + i, 202 + 4 * j + i, -(105 + 4 * j + i), -(201 + 4 * j + i)};
  Plane Surface(1 + c) = {1 + c};
EndFor
Transfinite Surface {1:6};
Recombine Surface {1:6};
fork[] = Extrude {0, width, 0} { Surface{1:6}; Layers{1}; Recombine; };
Physical Volume("body") = Volume{:};
Physical Surface("stem") = {fork[2]};
