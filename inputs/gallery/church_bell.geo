// Church bell around z, its mouth in the plane z = 0. All lengths are in units of the thickness of the sound bow. The main
// measures are those of Mersenne ("Harmonie universelle", 1636) and of the Encyclopedie (volume 3, 1753, "Cloche"): the mouth
// is 15 units wide, the shoulder half as wide, and the shoulder is 12 units high. The curve between them is our own;
// `idiophone tune` has found its five free numbers. The crown is a plate with a hole for the bolt.
DefineConstant[
  unit = {0.03, Min 0, Name "Church bell/1 Thickness of the sound bow (m)"}
  around = {3, Min 1, Step 1, Name "Church bell/2 Cells around a quarter"}
  quarters = {4, Choices {2, 4}, Name "Church bell/3 Quarters; 2 are the half with y > 0, cut at the group plane"}
  flare = {0.1224, Name "Church bell/4 Shift of the wall above the sound bow, outwards (units)"}
  waist = {-0.0825, Name "Church bell/5 Shift of the waist, outwards (units)"}
  lower = {1, Min 0, Name "Church bell/6 Thickness above the sound bow (units)"}
  upper = {0.25573, Min 0, Name "Church bell/7 Thickness of the waist (units)"}
  crown = {0.3, Min 0, Name "Church bell/8 Thickness of the crown (units)"}
  hexahedra = {1, Choices {0, 1}, Name "Church bell/9 Hexahedra"}
];
If (unit <= 0 || lower <= 0 || upper <= 0 || crown <= 0 || around < 1 || around != Floor(around))
  Error("unit, lower, upper and crown must be above 0, around a whole number from 1 on");
  Exit;
EndIf
// Outer and inner profile from the lip to the bolt's hole, in units: radius, height.
ro[] = {7.5, 7.1, 6.0 + flare, 5.0 + flare, 4.35 + waist, 4.0 + waist, 3.75, 1.0};
zo[] = {0.0, 1.1, 2.6, 4.6, 7.2, 9.6, 12.0, 12.4};
middle = (lower + upper) / 2;
ri[] = {7.2, 6.15, ro[2] - lower, ro[3] - middle, ro[4] - upper, ro[5] - upper, ro[6] - 0.4, 1.0};
zi[] = {0.0, 0.9, 2.3, 4.4, 7.1, 9.5, 12.1 - crown, 12.4 - crown};
last = 7;
For i In {0:last}
  Point(1 + i) = {unit * ro[i], 0, unit * zo[i]};
  Point(21 + i) = {unit * ri[i], 0, unit * zi[i]};
EndFor
// Five sections: sound bow, flare, waist (two), shoulder; then the crown.
For i In {0:last - 1}
  Line(1 + i) = {1 + i, 2 + i};
  Line(21 + i) = {21 + i, 22 + i};
EndFor
For i In {0:last}
  Line(41 + i) = {1 + i, 21 + i};
  Transfinite Curve {41 + i} = 2;
EndFor
sections[] = {};
For i In {0:last - 1}
  Curve Loop(1 + i) = {1 + i, 42 + i, -(21 + i), -(41 + i)};
  Plane Surface(1 + i) = {1 + i};
  Transfinite Curve {1 + i, 21 + i} = 2;
  sections[] += {1 + i};
EndFor
Transfinite Surface {:};
Recombine Surface {:};
hole[] = {};
cut[] = {sections[]};
For quarter In {1:quarters}
  next[] = {};
  For i In {0:last - 1}
    part[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Surface{sections[i]}; Layers{around}; Recombine; };
    next[] += {part[0]};
    If (i == last - 1)
      hole[] += {part[3]};
    EndIf
  EndFor
  sections[] = next[];
EndFor
Coherence;
Physical Volume("body") = Volume{:};
Physical Surface("bolt") = {hole[]};
If (quarters == 2)
  Physical Surface("plane") = {cut[], sections[]};
EndIf
