"""Triangulated surfaces for VTK, made from numpy arrays."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer


def surface_of(points, triangles):
    """A source of a surface. points: [n x 3], m; triangles: [n x 3] numbers of points."""
    surface = vtkPolyData()
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, 3 * len(triangles) + 1, 3), deep=True),
                  numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles, dtype=np.int64).ravel(), deep=True))
    surface.SetPolys(cells)
    move(surface, points)
    source = vtkTrivialProducer()
    source.SetOutput(surface)
    return source


def move(surface, points):
    """Puts the points of a surface [n x 3] elsewhere, m."""
    place = vtkPoints()
    place.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    surface.SetPoints(place)


def paint(surface, values):
    """Gives each point a value to be coloured by. [n]"""
    surface.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(values, dtype=float), deep=True))
