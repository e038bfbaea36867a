# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws surfaces and curves with VTK, without a screen, into PNG files."""

import math

import numpy as np
import vtk
from figure_colors import INK, SURFACE, WHITE
from figure_light import Stage, light, points_of, unit
from PIL import Image, ImageDraw, ImageFont
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

OVERSAMPLING = 2
THICK = 0.005  # the width from which on tubes have round ends, relative to what is drawn
SHARP_CORNER = math.cos(math.radians(25))
LETTER_SIZE = 1 / 46  # of panel letters, relative to the width of a picture


def color(name):
    """The parts of '#rrggbb', from 0 to 1."""
    return tuple(int(name[i:i + 2], 16) / 255 for i in (1, 3, 5))


def poly_data(points, faces=(), lines=()):
    data, places = vtk.vtkPolyData(), vtk.vtkPoints()
    places.SetData(numpy_to_vtk(np.array(points, float).reshape(-1, 3), deep=True))
    data.SetPoints(places)
    for cells, use in ((faces, data.SetPolys), (lines, data.SetLines)):
        ends = np.cumsum([0, *map(len, cells)])
        corners = np.fromiter((i for cell in cells for i in cell), np.int64, ends[-1])
        array = vtk.vtkCellArray()
        array.SetData(numpy_to_vtkIdTypeArray(ends, deep=True), numpy_to_vtkIdTypeArray(corners, deep=True))
        use(array)
    return data


def polyline_data(polylines):
    points, lines = [], []
    for line in polylines:
        lines.append(range(len(points), len(points) + len(line)))
        points += line
    return poly_data(points, lines=lines)


def texture_of(picture):
    """An image as VTK takes it, with its border going on beyond it."""
    pixels = np.ascontiguousarray(np.asarray(picture)[::-1])
    data = vtk.vtkImageData()
    data.SetDimensions(picture.width, picture.height, 1)
    data.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(-1, 3), deep=True))
    texture = vtk.vtkTexture()
    texture.SetInputData(data)
    texture.RepeatOff()
    texture.EdgeClampOn()
    texture.InterpolateOn()
    texture.MipmapOn()
    return texture


def split_at_corners(line):
    """The pieces of a polyline between sharp corners, at which a single tube would become thin."""
    pieces = [[line[0]]]
    for before, p, after in zip(line, line[1:], line[2:]):
        pieces[-1].append(p)
        if np.dot(unit(np.subtract(p, before)), unit(np.subtract(after, p))) < SHARP_CORNER:
            pieces.append([p])
    pieces[-1].append(line[-1])
    return pieces


def without_repetitions(line):
    return [p for p, before in zip(line, [None, *line]) if p != before]


def cut_into_dashes(line, length):
    """Dashes of about this length with gaps of the same length, which leave no gap at a sharp corner: zigzags of edges
    stay recognizable when their edges are shorter than the dashes."""
    pieces = split_at_corners(without_repetitions(line))
    return [dash for piece in pieces for dash in dashes_between_corners(piece, length)]


def dashes_between_corners(line, length):
    line = [np.array(p, float) for p in line]
    ends = np.concatenate(([0], np.cumsum([np.linalg.norm(b - a) for a, b in zip(line, line[1:])])))
    count = max(1, round(ends[-1] / length / 2)) if ends[-1] > length else 0
    period = ends[-1] / max(1, count)

    def at(d):
        return tuple(np.interp(d, ends, [p[i] for p in line]) for i in range(3))

    middles = [(k + 0.5) * period for k in range(count)]  # of the gaps
    starts, stops = [0, *(m + period / 4 for m in middles)], [*(m - period / 4 for m in middles), ends[-1]]
    return [[at(a), *(tuple(p) for p, d in zip(line, ends) if a < d < b), at(b)] for a, b in zip(starts, stops)]


class Panel:
    """A part of a picture with a camera of its own. Widths and radii are parts of the size of what is drawn."""

    def __init__(self, size):
        self.size = size
        self.actors = []
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)

    def _add(self, source, name, is_port=True):
        mapper = vtk.vtkPolyDataMapper()
        if is_port:
            mapper.SetInputConnection(source.GetOutputPort())
        else:
            mapper.SetInputData(source)
        mapper.ScalarVisibilityOff()
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(color(name))
        mapper.Update()
        if mapper.GetInput().GetNumberOfPoints():
            self.renderer.AddActor(actor)
            self.actors.append(actor)
        return actor

    def surface(self, points, faces, name=SURFACE, is_smooth=True):
        data = poly_data(points, faces)
        if not is_smooth:
            actor = self._add(data, name, is_port=False)
            actor.GetProperty().SetInterpolationToFlat()
        else:
            normals = vtk.vtkPolyDataNormals()
            normals.SetInputData(data)
            normals.SetFeatureAngle(40)
            normals.ConsistencyOff()
            actor = self._add(normals, name)
        return actor

    def colored_surface(self, points, faces, values, colors):
        """A smooth surface with a number per point. `colors`: pairs of a number and a color, in order."""
        data = poly_data(points, faces)
        data.GetPointData().SetScalars(numpy_to_vtk(np.array(values, float), deep=True))
        normals = vtk.vtkPolyDataNormals()
        normals.SetInputData(data)
        normals.SetFeatureAngle(40)
        actor = self._add(normals, SURFACE)
        ramp = vtk.vtkColorTransferFunction()
        for value, name in colors:
            ramp.AddRGBPoint(value, *color(name))
        actor.GetMapper().ScalarVisibilityOn()
        actor.GetMapper().SetLookupTable(ramp)
        actor.GetMapper().InterpolateScalarsBeforeMappingOn()
        return actor

    def textured_surface(self, points, faces, corners, plane, picture):
        """A smooth surface with an image on the faces of which `corners` tells the places of their corners in it."""
        normals = vtk.vtkPolyDataNormals()
        normals.SetInputData(poly_data(points, faces))
        normals.SplittingOff()
        normals.ConsistencyOff()
        normals.Update()
        bends = vtk_to_numpy(normals.GetOutput().GetPointData().GetNormals())
        bare = [f for f, places in zip(faces, corners) if not places]
        laid = [f for f, places in zip(faces, corners) if places]
        for data, ends in ((poly_data(points, bare), np.arange(len(points))),
                           (poly_data([points[v] for f in laid for v in f], np.arange(3 * len(laid)).reshape(-1, 3)),
                            np.array(laid).ravel())):
            data.GetPointData().SetNormals(numpy_to_vtk(bends[ends], deep=True))
            actor = self._add(data, SURFACE, is_port=False)
        places = np.array([plane[i] for triple in corners for i in triple], float)
        data.GetPointData().SetTCoords(numpy_to_vtk(places, deep=True))
        actor.GetProperty().SetColor(color(WHITE))
        actor.SetTexture(texture_of(picture))

    def tubes(self, polylines, name, width):
        """Polylines as tubes, and unless they are thin, with round ends and corners."""
        lines = [line for line in map(without_repetitions, polylines) if len(line) > 1]
        if width >= THICK:
            lines = [piece for line in lines for piece in split_at_corners(line)]
            self.balls([p for line in lines for p in (line[0], line[-1])], name, width, 12)
        tubes = vtk.vtkTubeFilter()
        tubes.SetInputData(polyline_data(lines))
        tubes.SetRadius(width / 2 * self.size)
        tubes.SetNumberOfSides(12 if width >= THICK else 6)
        tubes.CappingOn()
        return self._add(tubes, name)

    def dashes(self, polylines, name, width):
        """Tubes with gaps, for curves that are not results."""
        self.tubes([dash for line in polylines for dash in cut_into_dashes(line, 3 * width * self.size)], name, width)

    def contours(self, points, faces, values, levels, name, width):
        """The lines on a surface where a number per point has certain levels, as tubes."""
        data = poly_data(points, faces)
        data.GetPointData().SetScalars(numpy_to_vtk(np.array(values, float), deep=True))
        contours = vtk.vtkContourFilter()
        contours.SetInputData(data)
        for i, level in enumerate(levels):
            contours.SetValue(i, level)
        strips = vtk.vtkStripper()
        strips.SetInputConnection(contours.GetOutputPort())
        strips.SetMaximumLength(100000)
        tubes = vtk.vtkTubeFilter()
        tubes.SetInputConnection(strips.GetOutputPort())
        tubes.SetRadius(width / 2 * self.size)
        tubes.SetNumberOfSides(6)
        actor = self._add(tubes, name)
        return actor

    def edges(self, points, faces, name=INK, width=0.0012):
        """The edges of some triangles as thin tubes."""
        pairs = {tuple(sorted((f[i], f[i - 1]))) for f in faces for i in range(len(f))}
        return self.tubes([[points[a], points[b]] for a, b in sorted(pairs)], name, width)

    def balls(self, points, name, width, sides=20):
        ball = vtk.vtkSphereSource()
        ball.SetRadius(width / 2 * self.size)
        ball.SetThetaResolution(sides)
        ball.SetPhiResolution(sides)
        glyphs = vtk.vtkGlyph3D()
        glyphs.SetInputData(poly_data(points))
        glyphs.SetSourceConnection(ball.GetOutputPort())
        glyphs.ScalingOff()
        actor = self._add(glyphs, name)
        return actor

    def look(self, direction, up=(0, 1, 0), target=None, zoom=1.0, has_ground=True):
        """Looks from `direction` at everything, or at `target` so much closer than that. The surface stands on a white
        ground, `up` being the direction from it."""
        self.direction, self.up, self.target, self.zoom, self.has_ground = direction, up, target, zoom, has_ground

    def _fitted_camera(self, aspect):
        """A camera from which what is drawn just fits into a panel of this width over height."""
        towards, up = unit(self.direction), unit(self.up)
        right = unit(np.cross(up, towards))
        axes = np.array([right, np.cross(towards, right), towards])
        seen = np.concatenate([points_of(actor) for actor in self.actors]) @ axes.T
        low, high = seen.min(axis=0), seen.max(axis=0)
        focus = axes.T @ ((low + high) / 2) if self.target is None else np.array(self.target)
        half = max((high[1] - low[1]) / 2, (high[0] - low[0]) / 2 / aspect)
        camera = vtk.vtkCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*focus)
        camera.SetPosition(*(focus + 3 * self.size * towards))
        camera.SetViewUp(*axes[1])
        camera.SetParallelScale(1.08 * half / self.zoom)
        camera.SetClippingRange(self.size, 5 * self.size)
        self.sun = unit(1.1 * (up if self.has_ground else towards) + axes.T @ np.array((-0.55, 0.0, 0.5)))
        return camera

    def picture(self, width, height):
        """The panel in a picture of so many pixels, each the mean of several."""
        camera = self._fitted_camera(width / height)
        stage = Stage(self.renderer)
        up = unit(self.up) if self.has_ground else None
        many = light(stage, camera, OVERSAMPLING * width, OVERSAMPLING * height, up, self.sun)
        stage.close()
        return many.reshape(height, OVERSAMPLING, width, OVERSAMPLING, 3).mean(axis=(1, 3))[::-1]


def add_letter(image, index, left):
    """The letter of a panel in its upper left corner."""
    size = round(LETTER_SIZE * image.width)
    font = ImageFont.truetype('DejaVuSans-Bold.ttf', size)
    ImageDraw.Draw(image).text((left + size // 4, size // 4), f'({"abcdefgh"[index]})', INK, font,
                              stroke_width=size // 8, stroke_fill=WHITE)


def to_image(panels, width, height, gap=0.02):
    """Panels side by side, with letters if there are several."""
    share = round(width * (1 - gap * (len(panels) - 1)) / len(panels))
    result = np.ones((height, width, 3))
    for i, panel in enumerate(panels):
        left = round(i * (share + gap * width))
        part = panel.picture(min(share, width - left), height)
        result[:, left:left + part.shape[1]] = part
    image = Image.fromarray((255 * result + 0.5).astype(np.uint8))
    for i in range(len(panels) if len(panels) > 1 else 0):
        add_letter(image, i, round(i * (share + gap * width)))
    return image


def write_picture(path, image):
    """WebP takes a fifth of a PNG, with no difference that is visible; the small picture of the overview is a PNG."""
    options = {'optimize': True} if path.suffix == '.png' else {'quality': 88, 'method': 6}
    image.convert('RGB').save(path, **options)


def size_of(points):
    """The diagonal of the box about some points."""
    return math.dist([min(p[i] for p in points) for i in range(3)], [max(p[i] for p in points) for i in range(3)])
