// A stick with a head at its end, as two volumes that share a face.
SetFactory("OpenCASCADE");
Box(1) = {0, -0.01, -0.01, 0.1, 0.02, 0.02};
Box(2) = {0.1, -0.02, -0.02, 0.04, 0.04, 0.04};
Coherence;
Mesh.MeshSizeMax = 0.02;
Physical Volume("stick") = {1};
Physical Volume("head") = {2};
Physical Surface("end") = Surface In BoundingBox{-1e-6, -1, -1, 1e-6, 1, 1};
