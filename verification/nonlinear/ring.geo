// A ring about the z axis: its cross section, thickness x width, lies between the radii radius -+ thickness/2 and
// between z = -+ width/2. Four equal quarters.
DefineConstant[
  radius = {0.1, Min 0, Name "Ring/1 Radius of its middle line (m)"}
  thickness = {0.005, Min 0, Name "Ring/2 Thickness, along the radius (m)"}
  width = {0.005, Min 0, Name "Ring/3 Width, along the axis (m)"}
  cells = {8, Min 1, Step 1, Name "Ring/4 Elements along a quarter"}
];

Point(1) = {radius - thickness / 2, 0, -width / 2};
Point(2) = {radius + thickness / 2, 0, -width / 2};
Point(3) = {radius + thickness / 2, 0, width / 2};
Point(4) = {radius - thickness / 2, 0, width / 2};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Curve {1:4} = 2;
Transfinite Surface {1};

section = 1;
quarters[] = {};
For quarter In {1:4}
  out[] = Extrude { {0, 0, 1}, {0, 0, 0}, Pi / 2 } { Surface{section}; Layers{cells}; };
  section = out[0];
  quarters[] += {out[1]};
EndFor
Coherence;

Physical Volume("body") = {quarters[]};
