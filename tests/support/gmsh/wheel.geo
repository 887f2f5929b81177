// A small wheel without lugs, made into the .msh files beside it by
//   gmsh -2 -format msh22 wheel.geo -o wheel22.msh; gmsh -2 -format msh41 wheel.geo -o wheel41.msh
// Coordinates in metres, hub at 0, 0; physical surfaces are the parts of the wheel.
Mesh.RecombineAll = 1;
radii[] = {0.03, 0.04, 0.05};
Point(1) = {0, 0, 0};
For k In {0:2}
  For q In {0:3}
    Point(10 + 4 * k + q) = {radii[k] * Cos(q * Pi / 2), radii[k] * Sin(q * Pi / 2), 0};
  EndFor
EndFor
For k In {0:2}
  For q In {0:3}
    Circle(100 + 4 * k + q) = {10 + 4 * k + q, 1, 10 + 4 * k + (q + 1) % 4};
  EndFor
EndFor
For k In {0:1}
  For q In {0:3}
    Line(200 + 4 * k + q) = {10 + 4 * k + q, 14 + 4 * k + q};
  EndFor
EndFor
For k In {0:1}
  For q In {0:3}
    Curve Loop(300 + 4 * k + q) = {200 + 4 * k + q, 104 + 4 * k + q, -(200 + 4 * k + (q + 1) % 4), -(100 + 4 * k + q)};
    Plane Surface(400 + 4 * k + q) = {300 + 4 * k + q};
  EndFor
EndFor
Transfinite Curve{100:111} = 7;
Transfinite Curve{200:203} = 3;
Transfinite Curve{204:207} = 2;
Transfinite Surface{400:407};
Physical Surface("intermediate") = {400:403};
Physical Surface("surface") = {404:407};
