// A straight bar's quarter: x in [0, length], y in [0, width/2], z in [0, thickness/2], for the bar of
// meshes/bar.geo and its planes of symmetry y = 0 and z = 0. With half the length, x = 0 is the third.
DefineConstant[
  length = {0.3, Min 0, Name "Quarter bar/1 Length (m)"}
  width = {0.03, Min 0, Name "Quarter bar/2 Width of the whole bar (m)"}
  thickness = {0.01, Min 0, Name "Quarter bar/3 Thickness of the whole bar (m)"}
  size = {0.005, Min 0, Name "Quarter bar/4 Element size (m)"}
  hexahedra = {0, Choices {0, 1}, Name "Quarter bar/5 Hexahedra instead of tetrahedra"}
];

Point(1) = {0, 0, 0};
Point(2) = {length, 0, 0};
Point(3) = {length, width / 2, 0};
Point(4) = {0, width / 2, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Transfinite Curve {1, 3} = Ceil(length / size - 1e-6) + 1;
Transfinite Curve {2, 4} = Ceil(width / (2 * size) - 1e-6) + 1;
Transfinite Surface {1} Alternate;

layers = Ceil(thickness / (2 * size) - 1e-6);
If (hexahedra)
  Recombine Surface {1};
  bar[] = Extrude {0, 0, thickness / 2} { Surface{1}; Layers{layers}; Recombine; };
Else
  bar[] = Extrude {0, 0, thickness / 2} { Surface{1}; Layers{layers}; };
EndIf

Physical Volume("body") = {bar[1]};
Physical Surface("middle_z") = {1};       // z = 0
Physical Surface("middle_y") = {bar[2]};  // y = 0
Physical Surface("start") = {bar[5]};     // x = 0
Physical Surface("end") = {bar[3]};       // x = length
