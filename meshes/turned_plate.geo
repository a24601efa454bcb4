// Square plate, centred at the origin: x and y in [-side/2, side/2], z in [-thickness/2, thickness/2].
// Its tetrahedra come in four quarters, each the one before turned by 90 degrees. So the mesh keeps apart what the
// square keeps apart: pairs of modes stay pairs, and modes that are still at the centre stay out of a strike there.
DefineConstant[
  side = {0.3, Min 0, Name "Turned plate/1 Side (m)"}
  thickness = {0.006, Min 0, Name "Turned plate/2 Thickness (m)"}
  size = {0.012, Min 0, Name "Turned plate/3 In-plane element size (m)"}
  layers = {1, Min 1, Step 1, Name "Turned plate/4 Layers across the thickness"}
  hexahedra = {0, Choices {0, 1}, Name "Turned plate/5 Hexahedra instead of tetrahedra"}
];
If (side <= 0 || thickness <= 0 || size <= 0)
  Error("side, thickness and size must be above 0");
  Exit;
EndIf
If (layers < 1 || layers != Floor(layers))
  Error("layers must be a whole number, at least 1");
  Exit;
EndIf

// Three by three points on the bottom, and above each, 9 numbers on, one on the top.
For k In {0:1}
  For j In {-1:1}
    For i In {-1:1}
      Point(5 + i + 3 * j + 9 * k) = {i * side / 2, j * side / 2, (k - 0.5) * thickness};
    EndFor
  EndFor
EndFor

plate[] = {}; bottom[] = {}; top[] = {}; rim[] = {};
x = 1; y = 0;
For quarter In {1:4}
  // Around it: the centre, the middle of a side, the corner, the middle of the next side.
  p[] = {5, 5 + x + 3 * y, 5 + (x - y) + 3 * (x + y), 5 - y + 3 * x};
  l = newl;
  For m In {0:3}
    Line(l + m) = {p[m], p[(m + 1) % 4]};
    Line(l + 4 + m) = {p[m] + 9, p[(m + 1) % 4] + 9};
    Line(l + 8 + m) = {p[m], p[m] + 9};
  EndFor
  Transfinite Curve {l:l + 7} = Ceil(side / (2 * size) - 1e-6) + 1;
  Transfinite Curve {l + 8:l + 11} = layers + 1;

  s = news;
  Curve Loop(s) = {l:l + 3};
  Curve Loop(s + 1) = {l + 4:l + 7};
  For m In {0:3}
    Curve Loop(s + 2 + m) = {l + m, l + 8 + (m + 1) % 4, -(l + 4 + m), -(l + 8 + m)};
  EndFor
  For m In {0:5}
    Plane Surface(s + m) = {s + m};
  EndFor
  Transfinite Surface {s} = {p[]};
  Transfinite Surface {s + 1} = {p[0] + 9, p[1] + 9, p[2] + 9, p[3] + 9};
  For m In {0:3}
    Transfinite Surface {s + 2 + m} = {p[m], p[(m + 1) % 4], p[(m + 1) % 4] + 9, p[m] + 9};
  EndFor
  Transfinite Surface {s + 4} = {p[2], p[3], p[3] + 9, p[2] + 9} Right;  // as the volume's tetrahedra have it

  If (hexahedra)
    Recombine Surface {s:s + 5};
  EndIf

  Surface Loop(s) = {s:s + 5};
  Volume(s) = {s};
  Transfinite Volume {s} = {p[0], p[1], p[2], p[3], p[0] + 9, p[1] + 9, p[2] + 9, p[3] + 9};
  plate[] += {s}; bottom[] += {s}; top[] += {s + 1}; rim[] += {s + 3, s + 4};
  turned = x;
  x = -y; y = turned;
EndFor
Coherence;  // the sides between the quarters were made twice

Physical Volume("body") = {plate[]};
Physical Surface("bottom") = {bottom[]};
Physical Surface("top") = {top[]};
Physical Surface("rim") = {rim[]};
