// Half of the half section of a bar of radius (or half-width) 2 with a sharp notch to 1.
b = 2; a = 1; l = 4; n = 2; // cells by length 1
Point(1) = {0, 0, 0}; Point(2) = {a, 0, 0}; Point(3) = {b, 0, 0};
Point(4) = {0, l, 0}; Point(5) = {a, l, 0}; Point(6) = {b, l, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 6}; Line(4) = {6, 5}; Line(5) = {5, 4};
Line(6) = {4, 1}; Line(7) = {2, 5};
Curve Loop(1) = {1, 7, 5, 6};  Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, -7}; Plane Surface(2) = {2};
Transfinite Curve {1, 5} = n*a + 1; Transfinite Curve {2, 4} = n*(b - a) + 1;
Transfinite Curve {3, 6, 7} = n*l + 1;
Transfinite Surface {1, 2}; Recombine Surface {1, 2};
Physical Curve("ligament") = {1}; Physical Curve("notch") = {2}; Physical Curve("side") = {3};
Physical Curve("end") = {4, 5}; Physical Curve("middle") = {6};
Physical Surface("bar") = {1, 2};
