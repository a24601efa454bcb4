// Solid sphere; its poles, above and below the centre, are nodes.
SetFactory("OpenCASCADE");
DefineConstant[
  radius = {0.05, Min 0, Name "Sphere/1 Radius (m)"}
  size = {0.02, Min 0, Name "Sphere/2 Element size (m)"}
  x = {0, Name "Sphere/3 Centre, x (m)"}
  y = {0, Name "Sphere/4 Centre, y (m)"}
  z = {0, Name "Sphere/5 Centre, z (m)"}
];

Sphere(1) = {x, y, z, radius};
Mesh.Algorithm3D = 1; // Delaunay: HXT would make another mesh in each run
Mesh.MeshSizeMin = size;
Mesh.MeshSizeMax = size;

Physical Volume("body") = {1};
Physical Surface("surface") = Boundary{ Volume{1}; };
