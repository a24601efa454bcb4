// Middle surface of a shell of revolution about z, for a body with a thickness. Its profile is a curve (B-spline) from the
// circle `inner` to the circle `rim`, near the five points (r, z).
SetFactory("OpenCASCADE");
DefineConstant[
  r1 = {0.01, Min 0, Name "Shell/1 Radius of the inner circle (m)"}  z1 = {0, Name "Shell/2 Its height (m)"}
  r2 = {0.03, Min 0, Name "Shell/3 Second point, radius (m)"}  z2 = {0, Name "Shell/4 Second point, height (m)"}
  r3 = {0.05, Min 0, Name "Shell/5 Third point, radius (m)"}  z3 = {0, Name "Shell/6 Third point, height (m)"}
  r4 = {0.07, Min 0, Name "Shell/7 Fourth point, radius (m)"}  z4 = {0, Name "Shell/8 Fourth point, height (m)"}
  r5 = {0.1, Min 0, Name "Shell/9 Radius of the rim (m)"}  z5 = {0, Name "Shell/10 Height of the rim (m)"}
  along = {6, Min 1, Step 1, Name "Shell/11 Cells along the profile"}
  around = {3, Min 1, Step 1, Name "Shell/12 Cells around a quarter"}
];
If (r1 <= 0 || r2 <= 0 || r3 <= 0 || r4 <= 0 || r5 <= 0)
  Error("the radii must be above 0");
  Exit;
EndIf
If (along < 1 || around < 1 || along != Floor(along) || around != Floor(around))
  Error("along and around must be whole numbers, at least 1");
  Exit;
EndIf

Point(1) = {r1, 0, z1};
Point(2) = {r2, 0, z2};
Point(3) = {r3, 0, z3};
Point(4) = {r4, 0, z4};
Point(5) = {r5, 0, z5};
BSpline(1) = {1:5};
profile = 1;
For quarter In {1:4}
  wall[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Curve{profile}; };
  profile = wall[0];
EndFor
Coherence;

e = 1e-6;
inner[] = Curve In BoundingBox{-r1 - e, -r1 - e, z1 - e, r1 + e, r1 + e, z1 + e};
rim[] = Curve In BoundingBox{-r5 - e, -r5 - e, z5 - e, r5 + e, r5 + e, z5 + e};
Transfinite Curve {:} = along + 1;
Transfinite Curve {inner[], rim[]} = around + 1;
Transfinite Surface {:};
Recombine Surface {:};

Physical Surface("body") = Surface{:};
Physical Curve("inner") = {inner[]};
Physical Curve("rim") = {rim[]};
