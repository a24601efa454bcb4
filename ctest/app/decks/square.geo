// The middle surface of a square plate; its normal is along z.
SetFactory("OpenCASCADE");
Rectangle(1) = {-0.1, -0.1, 0, 0.2, 0.2};
Transfinite Curve {1:4} = 5;
Transfinite Surface {1};
Physical Curve("rim") = {1:4};
