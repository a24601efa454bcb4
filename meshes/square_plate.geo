// Square plate, centred at the origin: x and y in [-side/2, side/2], z in [-thickness/2, thickness/2].
DefineConstant[
  side = {0.3, Min 0, Name "Square plate/1 Side (m)"}
  thickness = {0.006, Min 0, Name "Square plate/2 Thickness (m)"}
  size = {0.012, Min 0, Name "Square plate/3 In-plane element size (m)"}
  layers = {1, Min 1, Step 1, Name "Square plate/4 Layers across the thickness"}
  regular = {1, Choices {0, 1}, Name "Square plate/5 Regular triangulation"}
  bump = {1, Min 0, Name "Square plate/6 Below 1: regular cells shrink towards the rim"}
  hexahedra = {0, Choices {0, 1}, Name "Square plate/7 Hexahedra instead of tetrahedra"}
];
If (side <= 0 || thickness <= 0 || size <= 0 || bump <= 0)
  Error("side, thickness, size and bump must be above 0");
  Exit;
EndIf
If (layers < 1 || layers != Floor(layers))
  Error("layers must be a whole number, at least 1");
  Exit;
EndIf

z = -thickness / 2;
Point(1) = {-side / 2, -side / 2, z, size};
Point(2) = { side / 2, -side / 2, z, size};
Point(3) = { side / 2,  side / 2, z, size};
Point(4) = {-side / 2,  side / 2, z, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

If (regular || hexahedra)
  // An even number of cells with diagonals in turn: the triangulation has all the symmetries of the square, so it
  // doesn't split the plate's pairs of modes of equal frequency.
  cells = 2 * Ceil(side / (2 * size) - 1e-6);
  If (bump == 1)
    Transfinite Curve {1:4} = cells + 1;
  Else
    Transfinite Curve {1:4} = cells + 1 Using Bump bump;
  EndIf
  Transfinite Surface {1} Alternate;
EndIf

If (hexahedra)
  Recombine Surface {1};
  plate[] = Extrude {0, 0, thickness} { Surface{1}; Layers{layers}; Recombine; };
Else
  plate[] = Extrude {0, 0, thickness} { Surface{1}; Layers{layers}; };
EndIf

Physical Volume("body") = {plate[1]};
Physical Surface("bottom") = {1};
Physical Surface("top") = {plate[0]};
Physical Surface("rim") = {plate[2], plate[3], plate[4], plate[5]};
