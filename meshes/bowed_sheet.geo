// Rectangular sheet, centred in x and y, that bows upwards along its length, and across it as well: a piece of a torus
// with one layer of elements. The corners of its underside are at z = 0. Both bows must be above 0.
DefineConstant[
  length = {0.24, Min 0, Name "Bowed sheet/1 Length, along x (m)"}
  width = {0.15, Min 0, Name "Bowed sheet/2 Width, along y (m)"}
  thickness = {0.0015, Min 0, Name "Bowed sheet/3 Thickness (m)"}
  bow = {0.015, Min 0, Name "Bowed sheet/4 Rise of the middle along the length (m)"}
  cross_bow = {0.005, Min 0, Name "Bowed sheet/5 Rise of the middle across it (m)"}
  size = {0.01, Min 0, Name "Bowed sheet/6 In-plane element size (m)"}
  hexahedra = {0, Choices {0, 1}, Name "Bowed sheet/7 Hexahedra instead of tetrahedra"}
];
If (length <= 0 || width <= 0 || thickness <= 0 || bow <= 0 || cross_bow <= 0 || size <= 0)
  Error("length, width, thickness, bow, cross_bow and size must be above 0");
  Exit;
EndIf
If (bow > length / 2 || cross_bow > width / 2)
  Error("bow and cross_bow must be at most half of length and width");
  Exit;
EndIf

// Radii of the underside: of the arcs along the sheet, and of those across it at its ends.
along = (length^2 / 4 + bow^2) / (2 * bow);
across = (width^2 / 4 + cross_bow^2) / (2 * cross_bow);
half = Asin(length / (2 * along));
lean = Asin(width / (2 * across));

// The section at y < 0, an arc with its thickness, which leans out from the axis that it is then turned about.
axis = cross_bow - across;      // its height
centre = across + bow - along;  // of the arcs, from the axis
Point(1) = {0, -centre * Sin(lean), axis + centre * Cos(lean)};
For k In {0:1}
  r = along + k * thickness;
  out = centre + r * Cos(half);
  Point(2 + 2 * k) = {-r * Sin(half), -out * Sin(lean), axis + out * Cos(lean)};
  Point(3 + 2 * k) = {r * Sin(half), -out * Sin(lean), axis + out * Cos(lean)};
  Circle(1 + k) = {2 + 2 * k, 1, 3 + 2 * k};
EndFor
Line(3) = {2, 4};
Line(4) = {3, 5};
Curve Loop(1) = {1, 4, -2, -3};
Plane Surface(1) = {1};
even = hexahedra ? 1 : 2;  // cells whose diagonals come in turn
Transfinite Curve {1, 2} = even * Ceil(length / (even * size) - 1e-6) + 1;
Transfinite Curve {3, 4} = 2;
Transfinite Surface {1} Alternate;
slices = even * Ceil(width / (even * size) - 1e-6);

If (hexahedra)
  Recombine Surface {1};
  sheet[] = Extrude {{1, 0, 0}, {0, 0, axis}, -2 * lean} { Surface{1}; Layers{slices}; Recombine; };
Else
  sheet[] = Extrude {{1, 0, 0}, {0, 0, axis}, -2 * lean} { Surface{1}; Layers{slices}; };
EndIf

Physical Volume("body") = {sheet[1]};
Physical Surface("right") = {sheet[3]};
Physical Surface("left") = {sheet[5]};
