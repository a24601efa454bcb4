// Chair: a seat on four legs, with two posts and two rails behind it. It stands on the plane z = 0; its back is at -y.
SetFactory("OpenCASCADE");
DefineConstant[
  side = {0.4, Min 0, Name "Chair/1 Side of the seat (m)"}
  seat = {0.42, Min 0, Name "Chair/2 Height of the seat (m)"}
  height = {0.85, Min 0, Name "Chair/3 Height of the back (m)"}
  thickness = {0.02, Min 0, Name "Chair/4 Thickness of seat and rails (m)"}
  leg = {0.035, Min 0, Name "Chair/5 Width of a leg (m)"}
  size = {0.035, Min 0, Name "Chair/6 Element size (m)"}
];
If (side <= 0 || seat <= 0 || height <= 0 || thickness <= 0 || leg <= 0 || size <= 0)
  Error("side, seat, height, thickness, leg and size must be above 0");
  Exit;
EndIf
rail = 0.25 * (height - seat);  // height of a rail
If (2 * leg >= side || thickness >= seat || thickness > leg || rail <= 0)
  Error("the seat must be wider than two legs and above its thickness; rails no thicker than legs; the back above the seat");
  Exit;
EndIf

Box(1) = {-side / 2, -side / 2, seat - thickness, side, side, thickness};
For x In {0:1}
  left = (x - 0.5) * side - x * leg;
  Box(2 + x) = {left, side / 2 - leg, 0, leg, leg, seat - thickness};
  Box(4 + x) = {left, -side / 2, 0, leg, leg, height};
  Box(6 + x) = {-side / 2 + leg, -side / 2, seat + (1 + 2 * x) * rail, side - 2 * leg, thickness, rail};
EndFor
BooleanUnion{ Volume{1}; Delete; }{ Volume{2:7}; Delete; }
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;

Physical Volume("body") = Volume{:};
