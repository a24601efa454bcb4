// Middle surface of a bell: a surface of revolution about z, for a body with a thickness. The lip is in the plane z = 0;
// the upper rim, the crown, is a circle, where the bell can be held.
SetFactory("OpenCASCADE");
DefineConstant[
  radius = {0.08, Min 0, Name "Bell/1 Radius of the lip (m)"}
  height = {0.1, Min 0, Name "Bell/2 Height (m)"}
  waist = {0.05, Min 0, Name "Bell/3 Radius at half the height (m)"}
  crown = {0.04, Min 0, Name "Bell/4 Radius of the crown (m)"}
  size = {0.04, Min 0, Name "Bell/5 Largest element size (m)"}
];
If (radius <= 0 || height <= 0 || waist <= 0 || crown <= 0 || size <= 0)
  Error("radius, height, waist, crown and size must be above 0");
  Exit;
EndIf
If (crown > waist || waist > radius)
  Error("crown must be at most waist, and waist at most radius");
  Exit;
EndIf

// The profile: from the crown it turns down to the waist, and flares to the lip.
Point(1) = {crown, 0, height};
Point(2) = {waist, 0, height};
Point(3) = {waist, 0, height / 2};
Point(4) = {waist, 0, height / 4};
Point(5) = {radius, 0, 0};
BSpline(1) = {1:5};
profile = 1;
For quarter In {1:4}
  wall[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Curve{profile}; };
  profile = wall[0];
EndFor
Coherence;

e = 1e-6;
lip[] = Curve In BoundingBox{-radius - e, -radius - e, -e, radius + e, radius + e, e};
top[] = Curve In BoundingBox{-crown - e, -crown - e, height - e, crown + e, crown + e, height + e};
Transfinite Curve {:} = Ceil((waist - crown + Hypot(radius - waist, height)) / size - 1e-6) + 1;  // along the profile
Transfinite Curve {lip[], top[]} = Ceil(Pi / 2 * radius / size - 1e-6) + 1;
Transfinite Surface {:};
Recombine Surface {:};

Physical Surface("body") = Surface{:};
Physical Curve("lip") = {lip[]};
Physical Curve("crown") = {top[]};
