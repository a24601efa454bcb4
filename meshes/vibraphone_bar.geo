// Vibraphone bar along x, centred in x and y, its top in the plane z = 0. Its underside is an arch: the bar is
// centre + (thickness - centre) (|x|/arch)^power thick where |x| < arch, and `thickness` thick beyond. With aluminium of
// 70 GPa, 2700 kg/m3 and Poisson's ratio 0.33 the defaults tune the first three bending modes to 187, 748 and 1870 Hz.
DefineConstant[
  length = {0.36, Min 0, Name "Vibraphone bar/1 Length (m)"}
  width = {0.05, Min 0, Name "Vibraphone bar/2 Width (m)"}
  thickness = {0.013, Min 0, Name "Vibraphone bar/3 Thickness of the ends (m)"}
  centre = {0.00495, Min 0, Name "Vibraphone bar/4 Thickness in the middle (m)"}
  arch = {0.0991, Min 0, Name "Vibraphone bar/5 Half the length of the arch (m)"}
  power = {3.19, Min 0, Name "Vibraphone bar/6 Shape of the arch"}
  size = {0.01, Min 0, Name "Vibraphone bar/7 Element size along and across the bar (m)"}
  layers = {1, Min 1, Step 1, Name "Vibraphone bar/8 Layers across the thickness"}
];
If (length <= 0 || width <= 0 || thickness <= 0 || centre <= 0 || arch <= 0 || power <= 0 || size <= 0)
  Error("length, width, thickness, centre, arch, power and size must be above 0");
  Exit;
EndIf
If (layers < 1 || layers != Floor(layers))
  Error("layers must be a whole number, at least 1");
  Exit;
EndIf

along = 2 * Ceil(length / (2 * size) - 1e-6);
across = 2 * Ceil(width / (2 * size) - 1e-6);
underside[] = {};
For i In {0:along}
  x = (i / along - 0.5) * length;
  within = Fabs(x) < arch ? Fabs(x) / arch : 1;
  Point(i + 1) = {x, -width / 2, -centre - (thickness - centre) * within^power};
  underside[] += {i + 1};
EndFor
Point(along + 2) = {length / 2, -width / 2, 0};
Point(along + 3) = {-length / 2, -width / 2, 0};
Spline(1) = {underside[]};
Line(2) = {along + 1, along + 2};
Line(3) = {along + 2, along + 3};
Line(4) = {along + 3, 1};
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Transfinite Curve {1, 3} = along + 1;
Transfinite Curve {2, 4} = layers + 1;
Transfinite Surface {1} Alternate;

bar[] = Extrude {0, width, 0} { Surface{1}; Layers{across}; };

Physical Volume("body") = {bar[1]};
Physical Surface("underside") = {bar[2]};
Physical Surface("top") = {bar[4]};
