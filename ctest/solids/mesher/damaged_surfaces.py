"""A ball, a box and a cylinder as surfaces that gmsh can't fill."""
import numpy


def patch(place, rows, columns):
    """Triangles on the image of a square, as [triangles x corners x 3]."""
    u, v = numpy.meshgrid(numpy.linspace(0, 1, rows + 1), numpy.linspace(0, 1, columns + 1), indexing="ij")
    points = numpy.stack(numpy.broadcast_arrays(*place(u, v)), axis=-1)
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    return numpy.concatenate([numpy.stack(corners, axis=2).reshape(-1, 3, 3) for corners in ((a, b, c), (a, c, d))])


def on_cube(axis, side, u, v):
    """A place on one side of the cube from (-1, -1, -1) to (1, 1, 1)."""
    place = [0, 0, 0]
    place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3] = side, side * u, v
    return numpy.stack(numpy.broadcast_arrays(*place))


def cube_sides(place, count):
    """`place` maps points of the cube to points of the body."""
    return numpy.concatenate([
        patch(lambda u, v, axis=axis, side=side: place(on_cube(axis, side, 2 * u - 1, 2 * v - 1)), count, count)
        for axis in range(3) for side in (-1, 1)])


def ball(radius, count=40):
    def place(cube):
        cube = numpy.tan(numpy.pi / 4 * cube)
        return radius * cube / numpy.linalg.norm(cube, axis=0)
    return cube_sides(place, count)


def box(low, high, count=24):
    middle, half = (numpy.array(high) + low) / 2, (numpy.array(high) - low) / 2
    return cube_sides(lambda cube: middle[:, None, None] + half[:, None, None] * cube, count)


def cylinder(radius, low, high, around=120, along=40):
    def ring(u):
        return numpy.cos(2 * numpy.pi * u), numpy.sin(2 * numpy.pi * u)

    def disc(u, distance, z):
        x, y = ring(u)
        return radius * distance * x, radius * distance * y, z
    return numpy.concatenate([
        patch(lambda u, v: disc(u, 1, low + (high - low) * v), around, along),
        patch(lambda u, v: disc(u, v, high), around, 8), patch(lambda u, v: disc(u, 1 - v, low), around, 8)])


def with_holes(triangles, random):
    """Triangles are missing, lie twice and face the other way."""
    triangles = numpy.delete(triangles, random.choice(len(triangles), 12, replace=False), axis=0)
    turned = random.choice(len(triangles), 30, replace=False)
    triangles[turned] = triangles[turned][:, ::-1]
    return numpy.concatenate([triangles, triangles[random.choice(len(triangles), 20)]])


def with_fins(triangles, random):
    """Single triangles stand inside, and touch the surface from there."""
    centres = triangles.mean(axis=1)[random.choice(len(triangles), 20, replace=False)]
    ends = [.8 * centres + .002 * random.normal(size=centres.shape) for _ in range(2)]
    return numpy.concatenate([triangles, numpy.stack([centres, *ends], axis=1)])


def write_obj(path, triangles):
    with open(path, "w") as file:
        numpy.savetxt(file, triangles.reshape(-1, 3), "v %.10g %.10g %.10g")
        numpy.savetxt(file, 1 + numpy.arange(3 * len(triangles)).reshape(-1, 3), "f %d %d %d")
