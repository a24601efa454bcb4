"""The shapes of a deck's obstacles, all but half-spaces, for VTK."""

import numpy as np
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkLineSource, vtkSphereSource

from library.cinema.result import outside, vector
from library.cinema.surface import surface_of
from library.recording import fail, packages_of

SIDES = 72  # of what is round
TRIANGLES, TETRAHEDRA = {2: 3, 9: 6}, {4: 4, 11: 10}  # gmsh's numbers of these elements, and their nodes


def shape(name, obstacle, folder):
    """The VTK source of an obstacle's shape. obstacle: its section of the deck; folder: where its mesh is sought."""
    return {"box": _box, "sphere": _sphere, "cylinder": _cylinder,
            "surface": lambda section: _surface(name, section, folder)}[obstacle["shape"]](obstacle)


def _box(section):
    cube = vtkCubeSource()
    for axis, length in zip("XYZ", vector(section["size"])):
        getattr(cube, f"Set{axis}Length")(length)
    place = vtkTransform()
    place.Translate(vector(section["at"]))
    if "rotation" in section:
        place.RotateWXYZ(float(section["rotation"]["degrees"]), vector(section["rotation"]["axis"]))
    placed = vtkTransformPolyDataFilter()
    placed.SetInputConnection(cube.GetOutputPort())
    placed.SetTransform(place)
    return placed


def _sphere(section):
    sphere = vtkSphereSource()
    sphere.SetCenter(vector(section["at"]))
    sphere.SetRadius(float(section["radius"]))
    sphere.SetThetaResolution(SIDES)
    sphere.SetPhiResolution(SIDES // 2)
    return sphere


def _cylinder(section):
    direction = vector(section.get("direction", [0, 0, 1]))
    half = 0.5 * float(section["length"]) * direction / np.linalg.norm(direction)
    line = vtkLineSource()
    line.SetPoint1(vector(section["at"]) - half)
    line.SetPoint2(vector(section["at"]) + half)
    tube = vtkTubeFilter()
    tube.SetInputConnection(line.GetOutputPort())
    tube.SetRadius(float(section["radius"]))
    tube.SetNumberOfSides(SIDES)
    tube.CappingOn()
    return tube


def _surface(name, section, folder):
    path = folder / section["mesh"]
    if not path.is_file():
        fail(f"the shape of the obstacle {name} is in {section['mesh']}, and there is no file {path}: say by "
             "--deck-folder where the deck is")
    with packages_of("movie"):
        import gmsh  # here, since it loads slowly and few decks need it
    settings = [word for item in (section.get("parameters") or {}).items() for word in ("-setnumber", *item)]
    gmsh.initialize(["movie", "-v", "0", *settings], readConfigFiles=False)
    gmsh.option.setString("Geometry.OCCTargetUnit", "M")
    try:
        gmsh.open(str(path))
        if not len(gmsh.model.mesh.getElementTypes()):
            gmsh.model.mesh.generate(2)
    except Exception as error:  # gmsh raises nothing more specific
        fail(f"{path} can't be read: {error}")
    points, triangles = _triangles(gmsh.model.mesh)
    gmsh.finalize()
    if not len(triangles):
        fail(f"{path} has no surface")
    return surface_of(points + vector(section["at"]), triangles)


def _triangles(mesh):
    """Positions [n x 3] and triangles [n x 3] of gmsh's mesh: the outside of its tetrahedra, or all its triangles."""
    tags, positions, _ = mesh.getNodes()
    order = np.argsort(tags)

    def elements(kinds, corners):
        nodes = [np.reshape(mesh.getElementsByType(kind)[1], (-1, size))[:, :corners]
                 for kind, size in kinds.items()]
        return order[np.searchsorted(tags, np.concatenate(nodes).astype(tags.dtype), sorter=order)]

    positions = positions.reshape(-1, 3)
    tetrahedra = elements(TETRAHEDRA, 4)
    if len(tetrahedra):
        numbers, triangles = outside(tetrahedra)
        return positions[numbers], triangles
    return positions, elements(TRIANGLES, 3)
