// Crash cymbal around z, its rim in the plane z = 0: a cup with a hole, and a bow that becomes thinner towards the rim.
DefineConstant[
  hole = {0.006, Min 0, Name "Crash cymbal/1 Radius of the hole (m)"}
  cup = {0.06, Min 0, Name "Crash cymbal/2 Radius of the cup (m)"}
  rim = {0.2, Min 0, Name "Crash cymbal/3 Radius of the rim (m)"}
  cup_height = {0.02, Min 0, Name "Crash cymbal/4 Height of the cup (m)"}
  bow_height = {0.022, Min 0, Name "Crash cymbal/5 Height of the bow (m)"}
  thick = {0.0013, Min 0, Name "Crash cymbal/6 Thickness of the cup (m)"}
  thin = {0.0008, Min 0, Name "Crash cymbal/7 Thickness at the rim (m)"}
  along_cup = {2, Min 1, Step 1, Name "Crash cymbal/8 Cells along the cup"}
  along_bow = {6, Min 1, Step 1, Name "Crash cymbal/9 Cells along the bow"}
  around = {9, Min 1, Step 1, Name "Crash cymbal/10 Cells around a quarter"}
  hexahedra = {1, Choices {0, 1}, Name "Crash cymbal/11 Hexahedra"}
];
If (hole <= 0 || cup <= hole || rim <= cup || cup_height < 0 || bow_height < 0 || thick <= 0 || thin <= 0)
  Error("hole, cup and rim must be ascending radii above 0, and heights and thicknesses must not be negative");
  Exit;
EndIf
If (along_cup < 1 || along_bow < 1 || around < 1 || around != Floor(around) || along_cup != Floor(along_cup) ||
    along_bow != Floor(along_bow))
  Error("along_cup, along_bow and around must be whole numbers, at least 1");
  Exit;
EndIf
// Points of the middle surface: 0 to 6 on the cup, which ends in a fillet, and 6 to 12 on the bow, a parabola.
n = 6;
For i In {0:2 * n}
  s = i / n;
  If (i <= n)
    r[i] = hole + (cup - hole) * s;
    z[i] = bow_height * (1 - (cup / rim)^2) + cup_height * (1 + Cos(Pi * s^2)) / 2;
  Else
    r[i] = cup + (rim - cup) * (s - 1);
    z[i] = bow_height * (1 - (r[i] / rim)^2);
  EndIf
EndFor
For i In {0:2 * n}
  before = (i == 0) ? 0 : i - 1;
  after = (i == 2 * n) ? i : i + 1;
  dr = r[after] - r[before];
  dz = z[after] - z[before];
  half = ((i <= n) ? thick : thick + (thin - thick) * (i / n - 1)) / 2 / Sqrt(dr^2 + dz^2);
  Point(1 + i) = {r[i] - half * dz, 0, z[i] + half * dr};
  Point(101 + i) = {r[i] + half * dz, 0, z[i] - half * dr};
EndFor
For side In {0:100:100}
  Spline(side + 1) = {side + 1:side + 1 + n};
  Spline(side + 2) = {side + 1 + n:side + 1 + 2 * n};
EndFor
Line(201) = {1, 101};
Line(202) = {1 + n, 101 + n};
Line(203) = {1 + 2 * n, 101 + 2 * n};
For part In {1:2}
  Curve Loop(part) = {part, 201 + part, -(100 + part), -(200 + part)};
  Plane Surface(part) = {part};
EndFor
Transfinite Curve {1, 101} = along_cup + 1;
Transfinite Curve {2, 102} = along_bow + 1;
Transfinite Curve {201:203} = 2;
Transfinite Surface {1, 2};
Recombine Surface {1, 2};

sections[] = {1, 2};
For quarter In {1:4}
  next[] = {};
  For part In {0:1}
    swept[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Surface{sections[part]}; Layers{around}; Recombine; };
    next[] += {swept[0]};
  EndFor
  sections[] = next[];
EndFor
Coherence;
Physical Volume("body") = Volume{:};
