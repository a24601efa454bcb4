// A desk lamp in one piece, an outline in the x-z plane that is extruded along y: base, two arms and head, and three thin joints
// between them, at which it bends: ankle (0, 0.04), knee (-0.06, 0.16) and neck (0, 0.28). It stands on z = 0.
DefineConstant[
  depth = {0.06, Min 0, Name "Lamp/1 Depth along y (m)"}
  size = {0.03, Min 0, Name "Lamp/2 Element size (m)"}
  joint = {0.014, Min 0, Name "Lamp/3 Element size at the joints (m)"}
];
y = -depth / 2;
Point(1) = {-0.12, y, 0, size};  // base
Point(2) = {0.12, y, 0, size};
Point(3) = {0.12, y, 0.02, size};
Point(4) = {0.01, y, 0.02, joint};  // ankle
Point(5) = {0.009, y, 0.04, joint};
Point(6) = {0.0027, y, 0.0637, size};  // lower arm
Point(7) = {-0.0395, y, 0.1479, size};
Point(8) = {-0.054, y, 0.16, joint};  // knee
Point(9) = {-0.0395, y, 0.1721, size};  // upper arm
Point(10) = {0.0027, y, 0.2563, size};
Point(11) = {0.005, y, 0.274, joint};  // neck
Point(12) = {0.02, y, 0.274, joint};
Point(13) = {0.02, y, 0.262, size};  // head
Point(14) = {0.075, y, 0.262, size};
Point(15) = {0.075, y, 0.302, size};
Point(16) = {0.02, y, 0.302, size};
Point(17) = {0.02, y, 0.286, joint};
Point(18) = {-0.006, y, 0.286, joint};  // back over neck, upper arm, knee, lower arm and ankle to the base
Point(19) = {-0.0205, y, 0.2679, size};
Point(20) = {-0.0627, y, 0.1837, size};
Point(21) = {-0.066, y, 0.16, joint};
Point(22) = {-0.0627, y, 0.1363, size};
Point(23) = {-0.0205, y, 0.0521, size};
Point(24) = {-0.01, y, 0.038, joint};
Point(25) = {-0.01, y, 0.02, joint};
Point(26) = {-0.12, y, 0.02, size};
For p In {1:26}
  Line(p) = {p, p % 26 + 1};
EndFor
Curve Loop(1) = {1:26};
Plane Surface(1) = {1};
lamp[] = Extrude {0, depth, 0} { Surface{1}; Layers{2}; };
Physical Volume("body") = {lamp[1]};
