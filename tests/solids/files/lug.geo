// A lug with a hole, in millimeters; made into lug.msh, lug22.msh and lug.inp by Gmsh 4.8.4:
//   gmsh -3 lug.geo -o lug.msh; gmsh -3 -format msh22 lug.geo -o lug22.msh
//   gmsh -3 -string "Mesh.SaveGroupsOfNodes=1;" lug.geo -o lug.inp
SetFactory("OpenCASCADE");
Box(1) = {0, -15, 0, 60, 30, 10};
Cylinder(2) = {45, 0, -5, 0, 0, 20, 8, 2*Pi};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Mesh.CharacteristicLengthMin = 18;
Mesh.CharacteristicLengthMax = 18;
Mesh.ElementOrder = 2;
Mesh.HighOrderOptimize = 2;
hole() = Surface In BoundingBox{36, -9, -1, 54, 9, 11};
root() = Surface In BoundingBox{-1, -16, -1, 1, 16, 11};
Physical Surface("hole") = {hole()};
Physical Surface("root") = {root()};
Physical Volume("lug") = {3};
