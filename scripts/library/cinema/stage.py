"""The stage of a movie: bodies, obstacles, floors with the bodies' shadows, light, and the picture that is taken."""

import numpy as np
import vtkmodules.vtkInteractionStyle  # VTK draws only with these three loaded
import vtkmodules.vtkRenderingFreeType
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from matplotlib import colormaps
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkDiskSource
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkTextActor, vtkWindowToImageFilter)

from library.cinema.surface import move, paint, surface_of

BODIES = [(0.30, 0.53, 0.76), (0.84, 0.49, 0.22), (0.33, 0.59, 0.40), (0.62, 0.38, 0.60), (0.75, 0.68, 0.30)]
OBSTACLE, FLOOR, SHADOW, INK = (0.73, 0.71, 0.67), (0.84, 0.84, 0.83), (0.60, 0.60, 0.60), (0.2, 0.2, 0.2)
BACKGROUND = (0.93, 0.94, 0.95)
EDGE = 35        # degrees at which faces meet in an edge that is drawn sharp
FLOOR_SIZE = 6   # radius of a floor, in diagonals of the bodies' path


class Stage:
    """A window that nobody sees, with what is in it; on floors put on it last, the shadows of all.

    size: (width, height), pixels; light: where the light comes from, a unit vector [3]; fastest: m/s at the top of the
    colours, None where bodies have colours of their own; edges: whether the triangles of bodies are outlined."""

    def __init__(self, size, light, fastest=None, edges=False):
        self.light, self.edges, self.bodies, self.sources = light, edges, [], []
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(BACKGROUND)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)  # they would take three times as long without a graphics card
        self.renderer.UseFXAAOn()
        self.window.SetSize(*size)
        self.window.AddRenderer(self.renderer)
        self.label = self._text(size[1] // 40)
        self.colours = None if fastest is None else self._speeds(fastest, size[1] // 40)
        self._lamp(light, 0.75)

    def add_body(self, points, triangles):
        """A body, until it is moved at the points [n x 3]; triangles: [n x 3] numbers of points."""
        source = surface_of(points, triangles)
        actor = self._add(source, BODIES[len(self.bodies) % len(BODIES)])
        actor.GetProperty().SetEdgeVisibility(self.edges)
        if self.colours:
            actor.GetMapper().SetLookupTable(self.colours)
            actor.GetMapper().UseLookupTableScalarRangeOn()
        self.bodies.append(source.GetOutputDataObject(0))

    def add_obstacle(self, source):
        """Something that stands still, from its VTK source."""
        self._add(source, OBSTACLE)

    def add_floor(self, at, normal, centre, diagonal):
        """A half-space, as a disk of its plane around the centre that fades out and is not there seen from behind.
        at, normal, centre: [3]; diagonal: of the bodies' path, m."""
        normal = normal / np.linalg.norm(normal)
        disk = vtkDiskSource()
        disk.SetInnerRadius(0)
        disk.SetOuterRadius(FLOOR_SIZE * diagonal)
        disk.SetRadialResolution(24)
        disk.SetCircumferentialResolution(72)
        disk.Update()
        points = vtk_to_numpy(disk.GetOutput().GetPoints().GetData()).astype(float)
        distance = np.linalg.norm(points, axis=1) / (FLOOR_SIZE * diagonal)
        colour = np.empty((len(points), 4), dtype=np.uint8)
        colour[:, :3] = 255 * np.array(FLOOR) * (0.8 + 0.2 * np.dot(normal, self.light))
        colour[:, 3] = 255 * np.clip(1 - distance, 0, 1) ** 1.5
        disk.GetOutput().GetPointData().SetScalars(numpy_to_vtk(colour, deep=True))
        across = np.linalg.svd(normal[np.newaxis])[2][1:]  # two unit vectors of the plane
        across[1] *= np.sign(np.linalg.det([*across, normal]))
        move(disk.GetOutput(), points[:, :2] @ across + centre - normal * np.dot(normal, centre - at))
        actor = vtkActor()
        actor.SetMapper(vtkPolyDataMapper())
        actor.GetMapper().SetInputData(disk.GetOutput())
        actor.GetProperty().LightingOff()
        actor.GetProperty().BackfaceCullingOn()
        self.renderer.AddActor(actor)
        if np.dot(normal, self.light) > 0.2:
            for source in self.sources:
                self._cast(source, at + 1e-3 * diagonal * normal, normal)

    def show(self, time, points, speeds=None):
        """The bodies at a time, s. points: of each body [n x 3], m; speeds: of each body [n], m/s."""
        for number, surface in enumerate(self.bodies):
            move(surface, points[number])
            if speeds:
                paint(surface, speeds[number])
        self.label.SetInput(f"{time:.3f} s")

    def camera(self):
        """The camera, to be put somewhere."""
        return self.renderer.GetActiveCamera()

    def picture(self):
        """What the camera sees. [height x width x 3] bytes, from the top."""
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        width, height, _ = grab.GetOutput().GetDimensions()
        return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(height, width, 3)[::-1]

    def _add(self, source, colour):
        smooth = vtkPolyDataNormals()
        smooth.SetInputConnection(source.GetOutputPort())
        smooth.SetFeatureAngle(EDGE)
        actor = vtkActor()
        actor.SetMapper(vtkPolyDataMapper())
        actor.GetMapper().SetInputConnection(smooth.GetOutputPort())
        look = actor.GetProperty()
        look.SetColor(colour)
        look.SetEdgeColor(INK)
        look.SetAmbient(0.35)
        look.SetDiffuse(0.75)
        look.SetSpecular(0.25)
        look.SetSpecularPower(40)
        self.renderer.AddActor(actor)
        self.sources.append(source)
        return actor

    def _cast(self, source, at, normal):
        """The shadow of a surface: the surface itself, flattened on a plane along the light."""
        slant = np.outer(self.light, normal) / np.dot(normal, self.light)
        flatten = np.eye(4)
        flatten[:3, :3] -= slant
        flatten[:3, 3] = slant @ at
        matrix = vtkMatrix4x4()
        matrix.DeepCopy(flatten.ravel())
        shadow = vtkActor()
        shadow.SetMapper(vtkPolyDataMapper())
        shadow.GetMapper().SetInputConnection(source.GetOutputPort())
        shadow.GetMapper().ScalarVisibilityOff()
        shadow.SetUserMatrix(matrix)
        shadow.GetProperty().SetColor(SHADOW)
        shadow.GetProperty().LightingOff()
        self.renderer.AddActor(shadow)

    def _lamp(self, direction, strength):
        lamp = vtkLight()
        lamp.SetLightTypeToSceneLight()
        lamp.SetPosition(direction)
        lamp.SetFocalPoint(0, 0, 0)
        lamp.SetIntensity(strength)
        fill = vtkLight()
        fill.SetLightTypeToHeadlight()
        fill.SetIntensity(1 - strength)
        self.renderer.AddLight(lamp)
        self.renderer.AddLight(fill)

    def _text(self, height):
        label = vtkTextActor()
        label.GetTextProperty().SetFontSize(height)
        label.GetTextProperty().SetColor(INK)
        label.SetPosition(height, height)
        self.renderer.AddViewProp(label)
        return label

    def _speeds(self, fastest, height):
        colours = vtkLookupTable()
        colours.SetRange(0, fastest)
        colours.SetTable(numpy_to_vtk((255 * colormaps["viridis"](np.arange(256))).astype(np.uint8), deep=True))
        bar = vtkScalarBarActor()
        bar.SetLookupTable(colours)
        bar.SetTitle("speed, m/s")
        bar.SetNumberOfLabels(5)
        bar.SetLabelFormat("%.2g")
        bar.SetPosition(0.92, 0.1)
        bar.SetWidth(0.07)
        bar.SetHeight(0.5)
        bar.SetBarRatio(0.2)
        bar.SetVerticalTitleSeparation(height // 2)
        bar.UnconstrainedFontSizeOn()
        for style in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
            style.SetColor(INK)
            style.SetFontSize(height)
            style.ItalicOff()
            style.BoldOff()
            style.ShadowOff()
        self.renderer.AddViewProp(bar)
        return colours
