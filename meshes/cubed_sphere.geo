// A sphere of seven blocks, for sphere.geo and graded_sphere.geo: one around the centre, and six between its faces and the
// sphere. Uses radius, and of the lower and the upper end: inner[] and inner_z[], half the width and the height of the
// block around the centre; outer[] and outer_z[], those of the points on the sphere. Curves 1 to 12 are the block's edges
// along x, y and z, 13 to 24 the arcs above them, and 25 to 32 the lines between both.

// Corner i + 2 j + 4 k of the block, 8 numbers on the one above it on the sphere.
Point(1) = {0, 0, 0};
For k In {0:1}
  For j In {0:1}
    For i In {0:1}
      corner = 2 + i + 2 * j + 4 * k;
      Point(corner) = {(2 * i - 1) * inner[k], (2 * j - 1) * inner[k], inner_z[k]};
      Point(corner + 8) = {(2 * i - 1) * outer[k], (2 * j - 1) * outer[k], outer_z[k]};
    EndFor
  EndFor
EndFor

// The block's edges along x, y, z, 12 numbers on the arcs above them, and from 25 on the spokes between both.
from[] = {0, 2, 4, 6, 0, 1, 4, 5, 0, 1, 2, 3};
to[] = {1, 3, 5, 7, 2, 3, 6, 7, 4, 5, 6, 7};
For corner In {0:7}
  Line(25 + corner) = {2 + corner, 10 + corner};
EndFor
For e In {0:11}
  Line(1 + e) = {2 + from[e], 2 + to[e]};
  Circle(13 + e) = {10 + from[e], 1, 10 + to[e]};
  Curve Loop(13 + e) = {1 + e, 25 + to[e], -(13 + e), -(25 + from[e])};
  Plane Surface(13 + e) = {13 + e};
EndFor

// The edges around each face of the block; 6 numbers on the face on the sphere.
edges[] = {5, 11, -7, -9, 6, 12, -8, -10, 1, 10, -3, -9, 2, 12, -4, -11, 1, 6, -2, -5, 3, 8, -4, -7};
For f In {0:5}
  inside[] = {};
  outside[] = {};
  around[] = {};
  For e In {4 * f:4 * f + 3}
    sign = edges[e] > 0 ? 1 : -1;
    inside[] += {edges[e]};
    outside[] += {edges[e] + 12 * sign};
    around[] += {12 + Fabs(edges[e])};
  EndFor
  Curve Loop(1 + f) = {inside[]};
  Plane Surface(1 + f) = {1 + f};
  Curve Loop(7 + f) = {outside[]};
  Surface(7 + f) = {7 + f} In Sphere {1};
  Surface Loop(1 + f) = {1 + f, 7 + f, around[]};
  Volume(1 + f) = {1 + f};
EndFor
Surface Loop(7) = {1:6};
Volume(7) = {7};

Transfinite Surface {1:24};
Recombine Surface {1:24};
Transfinite Volume {1:7};

Physical Volume("body") = {1:7};
Physical Surface("surface") = {7:12};
