// A quarter of a plate or bar that is supported along lines at half its thickness: x in [0, length/2], y in
// [0, width/2], z in [-thickness/2, thickness/2]. The planes x = 0 and y = 0 are its planes of symmetry.
DefineConstant[
  length = {0.2, Min 0, Name "Quarter/1 Length of the whole, along x (m)"}
  width = {0.2, Min 0, Name "Quarter/2 Width of the whole, along y (m)"}
  thickness = {0.002, Min 0, Name "Quarter/3 Thickness (m)"}
  size = {0.01, Min 0, Name "Quarter/4 In-plane element size (m)"}
  hexahedra = {0, Choices {0, 1}, Name "Quarter/5 Hexahedra instead of tetrahedra"}
];

z = -thickness / 2;
Point(1) = {0, 0, z, size};
Point(2) = {length / 2, 0, z, size};
Point(3) = {length / 2, width / 2, z, size};
Point(4) = {0, width / 2, z, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve {1, 3} = Ceil(length / (2 * size) - 1e-6) + 1;
Transfinite Curve {2, 4} = Ceil(width / (2 * size) - 1e-6) + 1;
Transfinite Surface {1} Alternate;

If (hexahedra)
  Recombine Surface {1};
  lower[] = Extrude {0, 0, thickness / 2} { Surface{1}; Layers{1}; Recombine; };
  upper[] = Extrude {0, 0, thickness / 2} { Surface{lower[0]}; Layers{1}; Recombine; };
Else
  lower[] = Extrude {0, 0, thickness / 2} { Surface{1}; Layers{1}; };
  upper[] = Extrude {0, 0, thickness / 2} { Surface{lower[0]}; Layers{1}; };
EndIf
middle[] = Boundary{ Surface{lower[0]}; };

Physical Volume("body") = {lower[1], upper[1]};
Physical Surface("middle_x") = {lower[5], upper[5]}; // x = 0
Physical Surface("middle_y") = {lower[2], upper[2]}; // y = 0
Physical Curve("edge_x") = {Abs(middle[1])};         // x = length/2, z = 0
Physical Curve("edge_y") = {Abs(middle[2])};         // y = width/2, z = 0
Physical Curve("middle_line") = {Abs(middle[3])};    // x = 0, z = 0
