// A vertical cut of height 1 in the ground: the toe is the origin.
n = 2; // cells by length 1
Point(1) = {-2, -1, 0}; Point(2) = {0, -1, 0}; Point(3) = {1, -1, 0}; Point(4) = {-2, 0, 0};
Point(5) = {0, 0, 0};   Point(6) = {1, 0, 0};  Point(7) = {-2, 1, 0}; Point(8) = {0, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 6}; Line(4) = {6, 5}; Line(5) = {5, 8};
Line(6) = {8, 7}; Line(7) = {7, 4}; Line(8) = {4, 1}; Line(9) = {4, 5}; Line(10) = {2, 5};
Curve Loop(1) = {1, 10, -9, 8};  Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, -10};  Plane Surface(2) = {2};
Curve Loop(3) = {9, 5, 6, 7};    Plane Surface(3) = {3};
Transfinite Curve {1, 6, 9} = 2*n + 1; Transfinite Curve {2, 3, 4, 5, 7, 8, 10} = n + 1;
Transfinite Surface {1, 2, 3}; Recombine Surface {1, 2, 3};
Physical Curve("bottom") = {1, 2}; Physical Curve("sides") = {3, 7, 8};
Physical Curve("free") = {4, 5, 6};
Physical Surface("ground") = {1, 2, 3};
