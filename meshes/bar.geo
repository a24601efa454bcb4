// Straight bar along x: x in [0, length], y in [-width/2, width/2], z in [-thickness/2, thickness/2].
DefineConstant[
  length = {0.3, Min 0, Name "Bar/1 Length (m)"}
  width = {0.03, Min 0, Name "Bar/2 Width (m)"}
  thickness = {0.01, Min 0, Name "Bar/3 Thickness (m)"}
  size = {0.015, Min 0, Name "Bar/4 In-plane element size (m)"}
  layers = {1, Min 1, Step 1, Name "Bar/5 Layers across the thickness"}
  hexahedra = {0, Choices {0, 1}, Name "Bar/6 Hexahedra instead of tetrahedra"}
];
If (length <= 0 || width <= 0 || thickness <= 0 || size <= 0)
  Error("length, width, thickness and size must be above 0");
  Exit;
EndIf
If (layers < 1 || layers != Floor(layers))
  Error("layers must be a whole number, at least 1");
  Exit;
EndIf

z = -thickness / 2;
Point(1) = {0, -width / 2, z, size};
Point(2) = {length, -width / 2, z, size};
Point(3) = {length, width / 2, z, size};
Point(4) = {0, width / 2, z, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

// Even numbers of cells with diagonals in turn: the triangulation is its own mirror image along and across the bar.
// Hexahedra are that in any number.
even = hexahedra ? 1 : 2;
Transfinite Curve {1, 3} = even * Ceil(length / (even * size) - 1e-6) + 1;
Transfinite Curve {2, 4} = even * Ceil(width / (even * size) - 1e-6) + 1;
Transfinite Surface {1} Alternate;

If (hexahedra)
  Recombine Surface {1};
  bar[] = Extrude {0, 0, thickness} { Surface{1}; Layers{layers}; Recombine; };
Else
  bar[] = Extrude {0, 0, thickness} { Surface{1}; Layers{layers}; };
EndIf

Physical Volume("body") = {bar[1]};
Physical Surface("bottom") = {1};
Physical Surface("top") = {bar[0]};
Physical Surface("tip") = {bar[3]};
Physical Surface("clamp") = {bar[5]};
Physical Surface("sides") = {bar[2], bar[4]};
