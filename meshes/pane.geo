// Square pane, centred at the origin, with surfaces inside along which it can break: straight cracks from a hub to the
// rim, and a ring of straight cracks around the hub.
SetFactory("OpenCASCADE");
DefineConstant[
  side = {0.3, Min 0, Name "Pane/1 Side (m)"}
  thickness = {0.008, Min 0, Name "Pane/2 Thickness (m)"}
  size = {0.03, Min 0, Name "Pane/3 Element size (m)"}
  rays = {6, Min 3, Step 1, Name "Pane/4 Cracks from the hub to the rim"}
  hub_x = {0.03, Name "Pane/5 Hub, x (m)"}
  hub_y = {0.02, Name "Pane/6 Hub, y (m)"}
  ring = {0.06, Min 0, Name "Pane/7 Distance of the ring's corners from the hub (m)"}
];
If (side <= 0 || thickness <= 0 || size <= 0 || ring <= 0)
  Error("side, thickness, size and ring must be above 0");
  Exit;
EndIf
If (rays < 3 || rays != Floor(rays))
  Error("rays must be a whole number, at least 3");
  Exit;
EndIf
If (Fabs(hub_x) + ring >= side / 2 || Fabs(hub_y) + ring >= side / 2)
  Error("the ring must be inside the pane");
  Exit;
EndIf

half = thickness / 2;
Box(1) = {-side / 2, -side / 2, -half, side, side, thickness};

// Each crack is a rectangle through the thickness: a line at the lower face, extruded.
hub = newp;
Point(hub) = {hub_x, hub_y, -half};
For i In {0 : rays - 1}
  angle = 0.2 + 2 * Pi * i / rays;
  far[i] = newp;
  Point(far[i]) = {hub_x + 2 * side * Cos(angle), hub_y + 2 * side * Sin(angle), -half};
  corner[i] = newp;
  Point(corner[i]) = {hub_x + ring * Cos(angle), hub_y + ring * Sin(angle), -half};
EndFor
lines[] = {};
For i In {0 : rays - 1}
  ray = newl;
  Line(ray) = {hub, far[i]};
  lines[] += {ray};
  arc = newl;
  Line(arc) = {corner[i], corner[(i + 1) % rays]};
  lines[] += {arc};
EndFor
cracks[] = {};
For i In {0 : #lines[] - 1}
  made[] = Extrude {0, 0, thickness} { Curve{lines[i]}; };
  cracks[] += {made[1]};
EndFor
inside[] = BooleanIntersection{ Surface{cracks[]}; Delete; }{ Volume{1}; };
BooleanFragments{ Volume{1}; Delete; }{ Surface{inside[]}; Delete; }

e = 1e-6;
s = side / 2;
faces[] = Surface In BoundingBox{-s - e, -s - e, -half - e, s + e, s + e, -half + e};
faces[] += Surface In BoundingBox{-s - e, -s - e, half - e, s + e, s + e, half + e};
rim[] = Surface In BoundingBox{-s - e, -s - e, -half - e, -s + e, s + e, half + e};
rim[] += Surface In BoundingBox{s - e, -s - e, -half - e, s + e, s + e, half + e};
rim[] += Surface In BoundingBox{-s - e, -s - e, -half - e, s + e, -s + e, half + e};
rim[] += Surface In BoundingBox{-s - e, s - e, -half - e, s + e, s + e, half + e};
all[] = Surface{:};
all[] -= {faces[], rim[]};
Physical Volume("body") = {Volume{:}};
Physical Surface("rim") = {rim[]};
Physical Surface("cracks") = {all[]};
Mesh.MeshSizeMax = size;
