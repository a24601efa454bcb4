// Wood block along x with a slot that opens to one side, below its top plate; centred in x and y, its top at z = 0.
DefineConstant[
  length = {0.18, Min 0, Name "Wood block/1 Length (m)"}
  width = {0.06, Min 0, Name "Wood block/2 Width (m)"}
  height = {0.045, Min 0, Name "Wood block/3 Height (m)"}
  top = {0.009, Min 0, Name "Wood block/4 Thickness of the top plate (m)"}
  slot = {0.008, Min 0, Name "Wood block/5 Height of the slot (m)"}
  back = {0.012, Min 0, Name "Wood block/6 Thickness behind the slot (m)"}
  cells = {5, Min 1, Step 1, Name "Wood block/7 Cells along the block"}
  hexahedra = {1, Choices {0, 1}, Name "Wood block/8 Hexahedra"}
];
If (length <= 0 || top <= 0 || slot <= 0 || back <= 0 || back >= width || top + slot >= height)
  Error("lengths must be above 0, back below width, top and slot together below height");
  Exit;
EndIf
If (cells < 1 || cells != Floor(cells))
  Error("cells must be a whole number, at least 1");
  Exit;
EndIf
y[] = {-width / 2, width / 2 - back, width / 2};
z[] = {-height, -top - slot, -top, 0};
For i In {0:2}
  For j In {0:3}
    Point(1 + 3 * j + i) = {-length / 2, y[i], z[j]};
  EndFor
EndFor
For j In {0:3}
  For i In {0:1}
    Line(101 + 3 * j + i) = {1 + 3 * j + i, 2 + 3 * j + i};
    Transfinite Curve {101 + 3 * j + i} = i == 0 ? 3 : 2;
  EndFor
EndFor
For j In {0:2}
  For i In {0:2}
    Line(201 + 3 * j + i) = {1 + 3 * j + i, 4 + 3 * j + i};
    Transfinite Curve {201 + 3 * j + i} = 2;
  EndFor
EndFor
column[] = {0, 1, 1, 0, 1};
row[] = {0, 0, 1, 2, 2};
For c In {0:4}
  i = column[c];
  j = row[c];
  Curve Loop(1 + c) = {101 + 3 * j + i, 202 + 3 * j + i, -(104 + 3 * j + i), -(201 + 3 * j + i)};
  Plane Surface(1 + c) = {1 + c};
EndFor
Transfinite Surface {1:5};
Recombine Surface {1:5};
Extrude {length, 0, 0} { Surface{1:5}; Layers{cells}; Recombine; }
Physical Volume("body") = Volume{:};
