#!/usr/bin/python3
"""make_parts.py FOLDER: writes ordinary parts as STEP, BREP, STL and OBJ files, as CAD programs, scanners and hand-written
exporters make them, and a few that can't be meshed. Lengths are some 0.1 m; in STEP files they are in millimetres."""
import math
import pathlib
import sys

import gmsh
import numpy
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonDataModel import vtkImplicitBoolean, vtkSphere
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricSuperToroid
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFlyingEdges3D, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearExtrusionFilter
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource, vtkSphereSource
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkRenderingFreeType import vtkVectorText

folder = pathlib.Path(sys.argv[1])
occ = gmsh.model.occ


# ---- parts of OpenCASCADE, in metres

def fuse(*volumes):
    return occ.fuse([(3, volumes[0])], [(3, v) for v in volumes[1:]])[0][0][1]


def cut(volume, *tools):
    return occ.cut([(3, volume)], [(3, t) for t in tools])[0][0][1]


def round_edges(volume, radius, which):
    occ.synchronize()
    curves = [c for _, c in gmsh.model.getBoundary([(3, volume)], combined=False, recursive=False) and
              gmsh.model.getEntities(1) if which(*gmsh.model.getBoundingBox(1, c))]
    return occ.fillet([volume], curves, [radius])[0][1]


def extrude(points, height, smooth=False):
    tags = [occ.addPoint(x, y, 0) for x, y in points]
    if smooth:
        curves = [occ.addSpline(tags + tags[:1])]
    else:
        curves = [occ.addLine(a, b) for a, b in zip(tags, tags[1:] + tags[:1])]
    surface = occ.addPlaneSurface([occ.addCurveLoop(curves)])
    return [tag for dim, tag in occ.extrude([(2, surface)], 0, 0, height) if dim == 3][0]


def revolve(points):
    tags = [occ.addPoint(x, 0, z) for x, z in points]
    curves = [occ.addLine(a, b) for a, b in zip(tags, tags[1:] + tags[:1])]
    surface = occ.addPlaneSurface([occ.addCurveLoop(curves)])
    return [tag for dim, tag in occ.revolve([(2, surface)], 0, 0, 0, 0, 0, 1, 2 * math.pi) if dim == 3][0]


def box():
    return occ.addBox(0, 0, 0, .1, .06, .02)


def bracket():
    angle = fuse(occ.addBox(0, 0, 0, .1, .06, .008), occ.addBox(0, 0, 0, .008, .06, .07))
    holes = [occ.addCylinder(x, y, -.01, 0, 0, .03, .005) for x in (.035, .08) for y in (.015, .045)]
    return cut(angle, *holes, occ.addCylinder(-.01, .03, .045, .03, 0, 0, .012))


def rounded_block():
    return round_edges(occ.addBox(0, 0, 0, .08, .05, .03), .008, lambda *bounds: bounds[5] - bounds[2] > .02)


def gear():
    teeth = 12
    points = []
    for i in range(teeth):
        for part, radius in ((-.3, .04), (-.15, .05), (.15, .05), (.3, .04)):
            angle = 2 * math.pi * (i + part) / teeth
            points.append((radius * math.cos(angle), radius * math.sin(angle)))
    return cut(extrude(points, .012), occ.addCylinder(0, 0, -.01, 0, 0, .04, .01))


def tube():
    return cut(occ.addCylinder(0, 0, 0, 0, 0, .2, .02), occ.addCylinder(0, 0, -.01, 0, 0, .22, .017))


def torus():
    return occ.addTorus(0, 0, 0, .05, .012)


def bell():
    outer = [(.012, .085), (.03, .075), (.035, .05), (.04, .02), (.055, 0)]
    inner = [(.051, 0), (.036, .02), (.031, .05), (.027, .071), (.012, .08)]
    return revolve([(.0, .085)] + outer + inner + [(.0, .08)])


def tuning_fork():
    prongs = [occ.addBox(x, -.004, 0, .006, .008, .12) for x in (-.012, .006)]
    return fuse(*prongs, occ.addBox(-.012, -.004, -.01, .024, .008, .015), occ.addCylinder(0, 0, -.05, 0, 0, .045, .004))


def cup():
    return cut(occ.addCylinder(0, 0, 0, 0, 0, .09, .04), occ.addCylinder(0, 0, .004, 0, 0, .1, .036))


def drilled_ball():
    return cut(occ.addSphere(0, 0, 0, .03), occ.addCylinder(0, 0, -.04, 0, 0, .08, .008))


def funnel():
    return cut(occ.addCone(0, 0, 0, 0, 0, .08, .04, .01), occ.addCone(0, 0, -.001, 0, 0, .082, .037, .007))


def guitar_plate():
    points = [(.2, 0), (.17, .12), (.06, .09), (-.1, .13), (-.2, 0), (-.1, -.13), (.06, -.09), (.17, -.12)]
    return cut(extrude(points, .003, smooth=True), occ.addCylinder(.06, 0, -.01, 0, 0, .02, .035))


def write_cad(name, shape):
    gmsh.clear()
    shape()
    occ.synchronize()
    if name.endswith("step"):
        occ.dilate(gmsh.model.getEntities(3), 0, 0, 0, 1000, 1000, 1000)  # m to mm
        occ.synchronize()
    gmsh.write(str(folder / name))


def write_facets(name, shape, size, **options):
    gmsh.clear()
    shape()
    occ.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    for option, value in options.items():
        gmsh.option.setNumber("Mesh." + option, value)
    gmsh.model.mesh.generate(2)
    gmsh.write(str(folder / name))
    for option in options:
        gmsh.option.setNumber("Mesh." + option, 0)


# ---- surfaces of VTK: points [n x 3], triangles [m x 3]

def arrays(source):
    clean = vtkCleanPolyData()
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    clean.SetInputConnection(triangles.GetOutputPort())
    clean.SetTolerance(1e-6)
    clean.Update()
    surface = clean.GetOutput()
    points = numpy_support.vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    cells = numpy_support.vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return points, cells[[len(set(cell)) == 3 for cell in cells]]


def ball():
    source = vtkSphereSource()
    source.SetRadius(.04)
    source.SetThetaResolution(24)
    source.SetPhiResolution(16)
    return arrays(source)


def letter():
    text = vtkVectorText()
    text.SetText("R")
    solid = vtkLinearExtrusionFilter()
    solid.SetInputConnection(text.GetOutputPort())
    solid.SetExtrusionTypeToVectorExtrusion()
    solid.SetVector(0, 0, .2)
    solid.CappingOn()
    points, triangles = arrays(solid)
    return .1 * points, triangles


def cushion():
    toroid = vtkParametricSuperToroid()
    toroid.SetRingRadius(.05)
    toroid.SetCrossSectionRadius(.02)
    toroid.SetN1(.6)
    toroid.SetN2(.8)
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(toroid)
    source.SetUResolution(40)
    source.SetVResolution(20)
    return arrays(source)


def scan():
    """Two balls and a rod as marching cubes see them: many slim triangles."""
    union = vtkImplicitBoolean()
    for centre, radius in (((0, 0, 0), .03), ((.05, .01, 0), .02)):
        sphere = vtkSphere()
        sphere.SetCenter(*centre)
        sphere.SetRadius(radius)
        union.AddFunction(sphere)
    sample = vtkSampleFunction()
    sample.SetImplicitFunction(union)
    sample.SetModelBounds(-.04, .08, -.04, .04, -.04, .04)
    sample.SetSampleDimensions(40, 27, 27)
    surface = vtkFlyingEdges3D()
    surface.SetInputConnection(sample.GetOutputPort())
    surface.SetValue(0, 0)
    return arrays(surface)


def knot():
    """A tube along a trefoil."""
    along, around, radius = 90, 10, .006
    t = numpy.linspace(0, 2 * math.pi, along, endpoint=False)
    centre = .012 * numpy.stack([numpy.sin(t) + 2 * numpy.sin(2 * t), numpy.cos(t) - 2 * numpy.cos(2 * t),
                                 -numpy.sin(3 * t)], axis=1)
    tangent = numpy.roll(centre, -1, axis=0) - numpy.roll(centre, 1, axis=0)
    tangent /= numpy.linalg.norm(tangent, axis=1)[:, None]
    side = numpy.cross(tangent, [0, 0, 1])
    side /= numpy.linalg.norm(side, axis=1)[:, None]
    up = numpy.cross(side, tangent)
    angle = 2 * math.pi * numpy.arange(around) / around
    points = (centre[:, None] + radius * (numpy.cos(angle)[None, :, None] * side[:, None] +
                                          numpy.sin(angle)[None, :, None] * up[:, None])).reshape(-1, 3)
    triangles = []
    for i in range(along):
        for j in range(around):
            a, b = i * around + j, i * around + (j + 1) % around
            c, d = ((i + 1) % along) * around + j, ((i + 1) % along) * around + (j + 1) % around
            triangles += [(a, c, b), (b, c, d)]
    return points, numpy.array(triangles)


CUBE = numpy.array([(x, y, z) for z in (0, .05) for y in (0, .05) for x in (0, .05)])
QUADS = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def cube_triangles(shift=(0, 0, 0)):
    return CUBE + shift, numpy.array([t for a, b, c, d in QUADS for t in ((a, b, c), (a, c, d))])


def write_stl(name, surface):
    points, triangles = surface
    with open(folder / name, "w") as file:
        file.write("solid part\n")
        for a, b, c in points[triangles]:
            normal = numpy.cross(b - a, c - a)
            normal = normal / max(numpy.linalg.norm(normal), 1e-300)
            file.write("facet normal {:.6e} {:.6e} {:.6e}\n outer loop\n".format(*normal))
            for point in (a, b, c):
                file.write("  vertex {:.7e} {:.7e} {:.7e}\n".format(*point))
            file.write(" endloop\nendfacet\n")
        file.write("endsolid part\n")


def write_obj(name, points, faces, corner="{}"):
    with open(folder / name, "w") as file:
        file.write("# a part\no part\ns off\n")
        for point in points:
            file.write("v {:.8g} {:.8g} {:.8g}\n".format(*point))
        file.write("vt 0 0\nvn 0 0 1\nusemtl none\n")
        for face in faces:
            file.write("f " + " ".join(corner.format(i + 1) for i in face) + "\n")


def joined(*surfaces):
    points, triangles, count = [], [], 0
    for p, t in surfaces:
        points.append(p)
        triangles.append(t + count)
        count += len(p)
    return numpy.concatenate(points), numpy.concatenate(triangles)


def main():
    folder.mkdir(parents=True, exist_ok=True)
    gmsh.initialize([], False)
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
    for shape in (box, bracket, rounded_block, gear, tube, torus, bell, tuning_fork):
        write_cad(shape.__name__ + ".step", shape)
    for shape in (cup, drilled_ball, funnel, guitar_plate):
        write_cad(shape.__name__ + ".brep", shape)
    write_facets("ring.stl", torus, .006)
    write_facets("angle.stl", bracket, .008)
    write_facets("pinion.stl", gear, .02, Binary=1)
    gmsh.finalize()

    write_stl("block.stl", cube_triangles())
    write_stl("ball.stl", ball())
    write_stl("letter.stl", letter())
    write_stl("scan.stl", scan())
    write_stl("cushion.stl", cushion())
    write_obj("cube.obj", CUBE, QUADS, "{}/1/1")
    write_obj("knot.obj", *knot())
    write_obj("balloon.obj", *ball(), corner="{}//1")
    points, triangles = cube_triangles()  # every face with vertices of its own, as exporters with normals write them
    write_obj("split_cube.obj", points[triangles].reshape(-1, 3), numpy.arange(3 * len(triangles)).reshape(-1, 3))

    points, triangles = ball()
    keep = points[triangles][:, :, 2].mean(axis=1) > -.02
    write_stl("refused_open_scan.stl", (points, triangles[keep]))
    write_obj("refused_open.obj", CUBE, QUADS[1:])
    write_stl("refused_two_on_an_edge.stl", joined(cube_triangles(), cube_triangles((.05, .05, 0))))
    write_stl("refused_crossing.stl", joined(cube_triangles(), cube_triangles((.02, .03, .01))))
    write_obj("refused_missing_vertex.obj", CUBE[:7], QUADS)
    (folder / "refused_empty.stl").write_text("solid nothing\nendsolid nothing\n")
    text = (folder / "bracket.step").read_text()
    (folder / "refused_cut.step").write_text(text[:len(text) // 2])
    (folder / "refused_text.brep").write_text("This is a letter, not a part.\n")


main()
