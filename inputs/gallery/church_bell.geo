// Church bell around z, its mouth in the plane z = 0, by the founders' rule of the Encyclopedie (Diderot and d'Alembert 1767,
// "Fonte des cloches"): the unit is the thickness of the sound bow; the mouth is 15 units wide, the shoulder 7.5 units, the
// height is 12 units, the wall above the middle a third of a unit thick. The crown is a plate with a hole for the bolt.
DefineConstant[
  unit = {0.03, Min 0, Name "Church bell/1 Thickness of the sound bow (m)"}
  around = {3, Min 1, Step 1, Name "Church bell/2 Cells around a quarter"}
  hexahedra = {1, Choices {0, 1}, Name "Church bell/3 Hexahedra"}
];
If (unit <= 0 || around < 1 || around != Floor(around))
  Error("unit must be above 0, around a whole number from 1 on");
  Exit;
EndIf
// Outer and inner profile from the lip to the bolt's hole, in units: radius, height.
ro[] = {7.5, 7.1, 6.0, 5.0, 4.35, 4.0, 3.75, 1.0};
zo[] = {0.0, 1.1, 2.6, 4.6, 7.2, 9.6, 12.0, 12.4};
ri[] = {7.2, 6.15, 5.35, 4.55, 4.0, 3.66, 3.35, 1.0};
zi[] = {0.0, 0.9, 2.3, 4.4, 7.1, 9.5, 11.6, 11.9};
last = 7;
For i In {0:last}
  Point(1 + i) = {unit * ro[i], 0, unit * zo[i]};
  Point(21 + i) = {unit * ri[i], 0, unit * zi[i]};
EndFor
// Five sections: sound bow, flare, waist (two), shoulder; then the crown.
first[] = {0, 1, 2, 3, 4, 5, 6};
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
For quarter In {1:4}
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
