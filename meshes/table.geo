// Table: a square top on four legs. It stands on the plane z = 0, centred at the z axis.
SetFactory("OpenCASCADE");
DefineConstant[
  side = {0.5, Min 0, Name "Table/1 Side of the top (m)"}
  height = {0.4, Min 0, Name "Table/2 Height (m)"}
  thickness = {0.02, Min 0, Name "Table/3 Thickness of the top (m)"}
  leg = {0.04, Min 0, Name "Table/4 Width of a leg (m)"}
  size = {0.04, Min 0, Name "Table/5 Element size (m)"}
];
If (side <= 0 || height <= 0 || thickness <= 0 || leg <= 0 || size <= 0)
  Error("side, height, thickness, leg and size must be above 0");
  Exit;
EndIf
If (2 * leg >= side || thickness >= height)
  Error("two legs must be narrower than the top, and the top thinner than the table is high");
  Exit;
EndIf

Box(1) = {-side / 2, -side / 2, height - thickness, side, side, thickness};
For x In {0:1}
  For y In {0:1}
    Box(2 + x + 2 * y) = {(x - 0.5) * side - x * leg, (y - 0.5) * side - y * leg, 0, leg, leg, height - thickness};
  EndFor
EndFor
BooleanUnion{ Volume{1}; Delete; }{ Volume{2:5}; Delete; }
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;

Physical Volume("body") = Volume{:};
