"""Pictures of a body of tetrahedra: its surface in motion, and its springs."""

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (VTK draws only with it loaded)
from matplotlib.colors import LinearSegmentedColormap
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkFiltersCore import vtkGlyph3D, vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

from library.cinema.surface import paint, surface_of

MOTION = LinearSegmentedColormap.from_list("motion", ["#12406e", "#4d86bd", "#b9cfe3", "#f6f3ec", "#efc3a4", "#cf6f45", "#8c2d12"])
SPRINGS = LinearSegmentedColormap.from_list("springs", ["#12406e", "#2f6ca6", "#b9cfe3", "#e6eef5", "#f3f6f9"])  # near to far
MASSES = LinearSegmentedColormap.from_list("masses", ["#b5482a", "#cf6f45", "#efc3a4", "#f6e6da", "#faf4ef"])
INK = LinearSegmentedColormap.from_list("ink", ["#222222", "#222222"])
LOOK = np.array([-0.72, 0.60, -0.30]) / np.linalg.norm([-0.72, 0.60, -0.30])
LAMPS = [(np.array([0.75, -0.35, 0.9]), 0.62), (-LOOK, 0.38)]  # from where, and how strong
OVERSAMPLING = 2  # pixels of the drawing to one of the picture, in each direction
ANGLE = 24        # degrees, of the view from bottom to top


class Picture:
    """A white square on which surfaces, lines and balls are put, seen from one side.

    size: pixels; centre [3], radius: of what is seen, m."""

    def __init__(self, size, centre, radius):
        self.size, self.centre = size, centre
        self.distance = radius / np.tan(np.radians(ANGLE / 2))
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(OVERSAMPLING * size, OVERSAMPLING * size)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetFocalPoint(centre)
        camera.SetPosition(centre - self.distance * LOOK)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(ANGLE)
        for place, strength in LAMPS:
            lamp = vtkLight()
            lamp.SetLightTypeToSceneLight()
            lamp.SetPosition(place)
            lamp.SetFocalPoint(0, 0, 0)
            lamp.SetIntensity(strength)
            self.renderer.AddLight(lamp)

    def add_surface(self, points, triangles, values):
        """Triangles [n x 3] of points [m x 3], m, in the colours of MOTION by values [m] from -1 to 1."""
        source = surface_of(points, triangles)
        paint(source.GetOutputDataObject(0), values)
        smooth = vtkPolyDataNormals()
        smooth.SetInputConnection(source.GetOutputPort())
        smooth.SetFeatureAngle(50)
        self._add(smooth, MOTION, (-1, 1))

    def add_lines(self, points, lines, radius, colours):
        """Tubes of this radius, m. points: [m x 3], m; lines: [n x k] numbers of points; colours: from near to far."""
        source = surface_of(points, np.empty((0, 3), int))
        data = source.GetOutputDataObject(0)
        cells = vtkCellArray()
        for line in lines:
            cells.InsertNextCell(len(line))
            for number in line:
                cells.InsertCellPoint(int(number))
        data.SetLines(cells)
        paint(data, self._depth(points))
        tubes = vtkTubeFilter()
        tubes.SetInputConnection(source.GetOutputPort())
        tubes.SetRadius(radius)
        tubes.SetNumberOfSides(8)
        self._add(tubes, colours, (0, 1))

    def add_balls(self, points, radius, colours):
        """Balls of this radius, m, at points [n x 3]; colours: from near to far."""
        source = surface_of(points, np.empty((0, 3), int))
        paint(source.GetOutputDataObject(0), self._depth(points))
        ball = vtkSphereSource()
        ball.SetRadius(radius)
        ball.SetThetaResolution(12)
        ball.SetPhiResolution(12)
        balls = vtkGlyph3D()
        balls.SetInputConnection(source.GetOutputPort())
        balls.SetSourceConnection(ball.GetOutputPort())
        balls.ScalingOff()
        self._add(balls, colours, (0, 1))

    def place(self, point):
        """Where a point [3] is in the picture: from the left and from the bottom, 0 to 1."""
        right = np.cross(LOOK, [0, 0, 1])
        right /= np.linalg.norm(right)
        offset = np.asarray(point) - self.centre
        height = 2 * (self.distance + offset @ LOOK) * np.tan(np.radians(ANGLE / 2))
        return 0.5 + offset @ right / height, 0.5 + offset @ np.cross(right, LOOK) / height

    def draw(self):
        """The picture. [size x size x 3], from 0 to 1."""
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.Update()
        pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).astype(float) / 255
        return pixels.reshape(self.size, OVERSAMPLING, self.size, OVERSAMPLING, 3).mean(axis=(1, 3))[::-1]

    @staticmethod
    def _depth(points):
        """Of each point: 0 for the nearest, 1 for the farthest."""
        depth = points @ LOOK
        return (depth - depth.min()) / np.ptp(depth)

    def _add(self, source, colours, values):
        table = vtkLookupTable()
        table.SetTable(numpy_to_vtk((255 * colours(np.linspace(0, 1, 256))).astype(np.uint8), deep=True))
        actor = vtkActor()
        actor.SetMapper(vtkPolyDataMapper())
        actor.GetMapper().SetInputConnection(source.GetOutputPort())
        actor.GetMapper().SetLookupTable(table)
        actor.GetMapper().SetScalarRange(*values)
        look = actor.GetProperty()
        look.SetAmbient(0.22)
        look.SetDiffuse(0.85)
        look.SetSpecular(0.12)
        look.SetSpecularPower(30)
        self.renderer.AddActor(actor)
