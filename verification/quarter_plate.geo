// A quarter of meshes/square_plate.geo: x and y in [0, side/2], z in [-thickness/2, thickness/2].
DefineConstant[
  side = {1.0, Min 0, Name "Quarter plate/1 Side of the whole plate (m)"}
  thickness = {0.02, Min 0, Name "Quarter plate/2 Thickness (m)"}
  size = {0.02, Min 0, Name "Quarter plate/3 In-plane element size (m)"}
  layers = {2, Min 1, Step 1, Name "Quarter plate/4 Layers across the thickness"}
  grading = {1, Min 0, Name "Quarter plate/5 Length of a cell over that of the next one outwards"}
  hexahedra = {0, Choices {0, 1}, Name "Quarter plate/6 Hexahedra instead of tetrahedra"}
];

z = -thickness / 2;
Point(1) = {0, 0, z, size};
Point(2) = {side / 2, 0, z, size};
Point(3) = {side / 2, side / 2, z, size};
Point(4) = {0, side / 2, z, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
cells = 2 * Ceil(side / (4 * size) - 1e-6);
Transfinite Curve {1, 2, -3, -4} = cells + 1 Using Progression 1 / grading;  // outwards
Transfinite Surface {1} Alternate;

If (hexahedra)
  Recombine Surface {1};
  plate[] = Extrude {0, 0, thickness} { Surface{1}; Layers{layers}; Recombine; };
Else
  plate[] = Extrude {0, 0, thickness} { Surface{1}; Layers{layers}; };
EndIf

Physical Volume("body") = {plate[1]};
Physical Surface("rim") = {plate[3], plate[4]};
Physical Surface("rim_x") = {plate[3]};    // x = side / 2
Physical Surface("rim_y") = {plate[4]};    // y = side / 2
Physical Surface("middle_y") = {plate[2]}; // y = 0
Physical Surface("middle_x") = {plate[5]}; // x = 0
