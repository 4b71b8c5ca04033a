// A quarter of a square plate with a hole, radius 0.2 of half the width.
R = 0.2; L = 1; n = 4; m = 8;
Point(1) = {0, 0, 0}; Point(2) = {R, 0, 0}; Point(3) = {L, 0, 0}; Point(4) = {L, L, 0};
Point(5) = {0, L, 0}; Point(6) = {0, R, 0}; Point(7) = {R*Cos(Pi/4), R*Sin(Pi/4), 0};
Line(1) = {2, 3}; Line(2) = {3, 4}; Line(3) = {4, 5}; Line(4) = {5, 6};
Circle(5) = {6, 1, 7}; Circle(6) = {7, 1, 2}; Line(7) = {7, 4};
Curve Loop(1) = {1, 2, -7, 6}; Plane Surface(1) = {1};
Curve Loop(2) = {7, 3, 4, 5};  Plane Surface(2) = {2};
Transfinite Curve {1, 4, 7} = m + 1; Transfinite Curve {2, 3, 5, 6} = n + 1;
Transfinite Surface {1} = {2, 3, 4, 7}; Transfinite Surface {2} = {7, 4, 5, 6};
Recombine Surface {1, 2};
Physical Curve("bottom") = {1}; Physical Curve("right") = {2}; Physical Curve("top") = {3};
Physical Curve("left") = {4}; Physical Curve("hole") = {5, 6};
Physical Surface("plate") = {1, 2};
