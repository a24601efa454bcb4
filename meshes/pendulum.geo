// Straight bar that hangs down from an axle: y in [-width/2, width/2], z in [-length, 0], x in [0, thickness]. The axle
// is the edge on the y axis, a line about which the bar can turn.
DefineConstant[
  length = {0.4, Min 0, Name "Pendulum/1 Length (m)"}
  width = {0.04, Min 0, Name "Pendulum/2 Width (m)"}
  thickness = {0.007, Min 0, Name "Pendulum/3 Thickness (m)"}
  size = {0.02, Min 0, Name "Pendulum/4 In-plane element size (m)"}
  hexahedra = {0, Choices {0, 1}, Name "Pendulum/5 Hexahedra instead of tetrahedra"}
];
If (length <= 0 || width <= 0 || thickness <= 0 || size <= 0)
  Error("length, width, thickness and size must be above 0");
  Exit;
EndIf

Point(1) = {0, -width / 2, 0};
Point(2) = {0, width / 2, 0};
Point(3) = {0, width / 2, -length};
Point(4) = {0, -width / 2, -length};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
even = hexahedra ? 1 : 2;  // cells whose diagonals come in turn
Transfinite Curve {1, 3} = even * Ceil(width / (even * size) - 1e-6) + 1;
Transfinite Curve {2, 4} = even * Ceil(length / (even * size) - 1e-6) + 1;
Transfinite Surface {1} Alternate;

If (hexahedra)
  Recombine Surface {1};
  bar[] = Extrude {thickness, 0, 0} { Surface{1}; Layers{1}; Recombine; };
Else
  bar[] = Extrude {thickness, 0, 0} { Surface{1}; Layers{1}; };
EndIf

Physical Volume("body") = {bar[1]};
Physical Curve("axle") = {1};
