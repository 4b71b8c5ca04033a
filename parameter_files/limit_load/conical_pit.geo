// A conical pit of radius 1 in a cylinder of radius 5, its flanks below the horizontal by this angle.
degrees = 30;
d = Tan(degrees*Pi/180);
Point(1) = {0, -5, 0}; Point(2) = {1, -5, 0}; Point(3) = {5, -5, 0};
Point(4) = {0, -d, 0}; Point(5) = {1, 0, 0};  Point(6) = {5, 0, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 6}; Line(4) = {6, 5}; Line(5) = {5, 4};
Line(6) = {4, 1}; Line(7) = {2, 5};
Curve Loop(1) = {1, 7, 5, 6};  Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, -7}; Plane Surface(2) = {2};
Transfinite Curve {1, 5} = 2; Transfinite Curve {2, 4} = 5; Transfinite Curve {3, 6, 7} = 6;
Transfinite Surface {1, 2}; Recombine Surface {1, 2};
Physical Curve("bottom") = {1, 2}; Physical Curve("axis") = {6}; Physical Curve("pit") = {5};
Physical Curve("top") = {4}; Physical Curve("right") = {3};
Physical Surface("body") = {1, 2};
