# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws surfaces, curves and labels with VTK and Pillow, without a screen."""

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
FLAT_CURVES, FLAT_VALUES = 1.0, 0.7  # how far curves, and colors that stand for values, are the same in shadows
MOST_BYTES = 300_000  # of a picture
LETTER_SIZE = 1 / 46  # of panel letters, relative to the width of a picture
LABEL_SIZE = 1 / 56  # of other text, likewise


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


def with_steps(line, length):
    """A polyline with further points on it, no farther than `length` from each other."""
    result = [line[0]]
    for p, q in zip(line, line[1:]):
        count = math.ceil(math.dist(p, q) / length)
        result += [tuple(a + k / count * (b - a) for a, b in zip(p, q)) for k in range(1, count + 1)]
    return result


def runs_of(line, is_wanted):
    """The longest pieces of a polyline of which all points are wanted."""
    runs = [[]]
    for p, wanted in zip(line, is_wanted):
        if wanted:
            runs[-1].append(p)
        elif runs[-1]:
            runs.append([])
    return [run for run in runs if len(run) > 1]


def cut_into_dashes(line, length):
    """Dashes of about this length with gaps of the same length. They leave no gap at a sharp corner, so that zigzags
    stay recognizable, unless corners are so close to each other that no gap would be left."""
    line = without_repetitions(line)
    pieces = split_at_corners(line)
    if 2 * sum(map(math.dist, line, line[1:])) < len(pieces) * length:
        pieces = [line]
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


def axes_of(direction, up):
    """The directions to the right and upwards in a picture that is seen from `direction`, and this direction."""
    towards = unit(direction)
    right = unit(np.cross(unit(up), towards))
    return np.array([right, np.cross(towards, right), towards])


def seen_height(points, aspect, direction, up=(0, 1, 0), zoom=1.0, **_):
    """The height of the part of space that a panel of this width over height shows when it looks at some points."""
    seen = np.asarray(points) @ axes_of(direction, up).T
    low, high = seen.min(axis=0), seen.max(axis=0)
    return 1.08 * max(high[1] - low[1], (high[0] - low[0]) / aspect) / zoom


class Panel:
    """A part of a picture with a camera of its own. `size` is the size of what is drawn; widths and radii are parts of
    `unit`, which is the same by default."""

    def __init__(self, size, unit=None):
        self.size, self.unit = size, unit or size
        self.actors, self.labels, self.bar, self.text = [], [], None, ''
        self.flatness, self.parts, self.undrawn = {}, [], []
        self.margin = 0  # the part of the width at the left in which nothing is drawn
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(1, 1, 1)

    def _add(self, source, name, is_port=True, flatness=FLAT_CURVES):
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
            self.flatness[actor] = flatness
        return actor

    def _add_surface(self, points, faces, data, name, flatness=0.0, is_port=False):
        self.parts.append((points, faces))
        return self._add(data, name, is_port, flatness)

    def surface(self, points, faces, name=SURFACE, is_smooth=True):
        data = poly_data(points, faces)
        if not is_smooth:
            actor = self._add_surface(points, faces, data, name)
            actor.GetProperty().SetInterpolationToFlat()
        else:
            normals = vtk.vtkPolyDataNormals()
            normals.SetInputData(data)
            normals.SetFeatureAngle(40)
            normals.ConsistencyOff()
            actor = self._add_surface(points, faces, normals, name, is_port=True)
        return actor

    def colored_surface(self, points, faces, values, colors):
        """A smooth surface with a number per point. `colors`: pairs of a number and a color, in order."""
        data = poly_data(points, faces)
        data.GetPointData().SetScalars(numpy_to_vtk(np.array(values, float), deep=True))
        normals = vtk.vtkPolyDataNormals()
        normals.SetInputData(data)
        normals.SetFeatureAngle(40)
        actor = self._add_surface(points, faces, normals, SURFACE, FLAT_VALUES, is_port=True)
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
            actor = self._add(data, SURFACE, is_port=False, flatness=0.0)
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
        tubes.SetRadius(width / 2 * self.unit)
        tubes.SetNumberOfSides(12 if width >= THICK else 6)
        tubes.CappingOn()
        return self._add(tubes, name)

    def dashes(self, polylines, name, width):
        """Tubes with gaps, for curves that are not results. They are not drawn where the surface faces away: parts of
        dashes beside an outline would not be recognized."""
        self.undrawn.append(([line for line in map(without_repetitions, polylines) if len(line) > 1], name, width))

    def _draw_dashes(self):
        for polylines, name, width in self.undrawn:
            length = 3 * width * self.unit
            fine = [with_steps(line, length / 6) for line in polylines]
            is_seen = iter(self.is_facing([p for line in fine for p in line]))
            runs = [run for line in fine for run in runs_of(line, [next(is_seen) for _ in line])]
            self.tubes([dash for run in runs for dash in cut_into_dashes(run, length)], name, width)
        self.undrawn = []

    def is_facing(self, places, least=0.1):
        """For each place whether the surface faces the viewer there: its normal and the direction to the viewer have at
        least this cosine."""
        return self.normals_at(places) @ unit(self.direction) >= least

    def normals_at(self, places):
        """The normals of the surface at the vertices that are nearest to some places."""
        corners = np.concatenate([np.array(points, float)[np.array(faces)] for points, faces in self.parts])
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])  # as long as twice the area
        points, vertex = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
        sums = np.zeros_like(points)
        np.add.at(sums, vertex.ravel(), across.repeat(3, axis=0))
        locator = vtk.vtkStaticPointLocator()
        data = poly_data(points)
        locator.SetDataSet(data)
        locator.BuildLocator()
        normals = sums / np.maximum(np.linalg.norm(sums, axis=1), 1e-30)[:, None]
        return normals[[locator.FindClosestPoint(p) for p in places]]

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
        tubes.SetRadius(width / 2 * self.unit)
        tubes.SetNumberOfSides(6)
        actor = self._add(tubes, name)
        return actor

    def edges(self, points, faces, name=INK, width=0.0012):
        """The edges of some triangles as thin tubes."""
        pairs = {tuple(sorted((f[i], f[i - 1]))) for f in faces for i in range(len(f))}
        return self.tubes([[points[a], points[b]] for a, b in sorted(pairs)], name, width)

    def balls(self, points, name, width, sides=20):
        ball = vtk.vtkSphereSource()
        ball.SetRadius(width / 2 * self.unit)
        ball.SetThetaResolution(sides)
        ball.SetPhiResolution(sides)
        glyphs = vtk.vtkGlyph3D()
        glyphs.SetInputData(poly_data(points))
        glyphs.SetSourceConnection(ball.GetOutputPort())
        glyphs.ScalingOff()
        actor = self._add(glyphs, name)
        return actor

    def arrows(self, starts, vectors, name, width):
        """Arrows of the lengths of the vectors, with shafts of this width."""
        data = poly_data(starts)
        data.GetPointData().SetVectors(numpy_to_vtk(np.array(vectors, float), deep=True))
        length = float(np.mean(np.linalg.norm(vectors, axis=1)))
        thickness = width * self.unit / length
        arrow = vtk.vtkArrowSource()
        arrow.SetShaftRadius(thickness / 2)
        arrow.SetTipRadius(1.6 * thickness)
        arrow.SetTipLength(min(0.5, 4.5 * thickness))
        arrow.SetShaftResolution(12)
        arrow.SetTipResolution(24)
        glyphs = vtk.vtkGlyph3D()
        glyphs.SetInputData(data)
        glyphs.SetSourceConnection(arrow.GetOutputPort())
        glyphs.SetScaleModeToScaleByVector()
        return self._add(glyphs, name)

    def label(self, point, text, name=INK, anchor='mm', shift=(0, 0)):
        """Writes text beside a point in space: `shift` is measured in heights of the text, right and down."""
        self.labels.append((point, text, name, anchor, shift))

    def title(self, text):
        """Writes text behind the letter of the panel, above the picture."""
        self.text = text

    def color_bar(self, colors, texts, title=''):
        """A bar of the colors of `colored_surface()` in a margin at the left, with texts at some numbers."""
        self.bar, self.margin = (colors, texts, title), 0.17

    def look(self, direction, up=(0, 1, 0), target=None, zoom=1.0, has_ground=True):
        """Looks from `direction` at everything, or at `target` so much closer than that. The surface stands on a white
        ground, `up` being the direction from it."""
        self.direction, self.up, self.target, self.zoom, self.has_ground = direction, up, target, zoom, has_ground

    def _fitted_camera(self, aspect):
        """A camera from which what is drawn just fits into a panel of this width over height."""
        up, axes = unit(self.up), axes_of(self.direction, self.up)
        towards = axes[2]
        points = np.concatenate([points_of(actor) for actor in self.actors])
        seen = points @ axes.T
        middle = axes.T @ ((seen.min(axis=0) + seen.max(axis=0)) / 2)
        focus = middle if self.target is None else np.array(self.target)
        self.height = seen_height(points, aspect * (1 - self.margin), self.direction, self.up, self.zoom)
        focus = focus - self.margin / 2 * aspect * self.height * axes[0]
        self.middle, self.plane = focus, axes[:2]
        camera = vtk.vtkCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*focus)
        camera.SetPosition(*(focus + 3 * self.size * towards))
        camera.SetViewUp(*axes[1])
        camera.SetParallelScale(self.height / 2)
        camera.SetClippingRange(self.size, 5 * self.size)
        self.sun = unit(1.1 * (up if self.has_ground else towards) + axes.T @ np.array((-0.55, 0.0, 0.5)))
        return camera

    def picture(self, width, height):
        """The panel in a picture of so many pixels, each the mean of several."""
        self._draw_dashes()
        camera = self._fitted_camera(width / height)
        stage = Stage(self.renderer)
        up = unit(self.up) if self.has_ground else None
        blur = round(3 * max(1, self.zoom))
        many = light(stage, camera, OVERSAMPLING * width, OVERSAMPLING * height, up, self.sun, self.flatness, blur)
        stage.close()
        return many.reshape(height, OVERSAMPLING, width, OVERSAMPLING, 3).mean(axis=(1, 3))[::-1]


def text_font(size, is_bold=False):
    return ImageFont.truetype(f'DejaVuSans{"-Bold" if is_bold else ""}.ttf', size)


def write_text(image, place, text, name, anchor, size, is_bold=False):
    ImageDraw.Draw(image).text(place, text, name, text_font(size, is_bold), anchor, stroke_width=size // 6,
                              stroke_fill=WHITE)


def annotate(image, panel, left, top, width, height):
    """The labels and the color bar of a panel."""
    size = round(LABEL_SIZE * image.width)
    for point, text, name, anchor, shift in panel.labels:
        x, y = panel.plane @ (np.array(point) - panel.middle) * height / panel.height
        place = left + width / 2 + x + shift[0] * size, top + height / 2 - y + shift[1] * size
        write_text(image, place, text, name, anchor, size, is_bold=True)
    if panel.text:
        letter = round(LETTER_SIZE * image.width)
        write_text(image, (left + 2.6 * letter, top - 0.93 * letter), panel.text, INK, 'lm', size, is_bold=True)
    if panel.bar:
        colors, texts, title = panel.bar
        (low, _), (high, _) = colors[0], colors[-1]
        start, length = left + size, round(0.5 * height)
        bottom = top + (height + length) // 2
        levels = np.linspace(high, low, length)
        parts = [np.interp(levels, [value for value, _ in colors], [color(name)[k] for _, name in colors])
                 for k in range(3)]
        column = (255 * np.stack(parts, axis=1) + 0.5).astype(np.uint8)[:, None]
        image.paste(Image.fromarray(column.repeat(size, axis=1)), (round(start), round(bottom - length)))
        for value, text in texts:
            y = bottom - length * (value - low) / (high - low)
            ImageDraw.Draw(image).line([start + size, y, start + 1.3 * size, y], INK, max(1, size // 12))
            write_text(image, (start + 1.5 * size, y), text, INK, 'lm', size)
        write_text(image, (start + size / 2, bottom - length - size), title, INK, 'mm', size, is_bold=True)


def add_letter(image, index, left, top):
    """The letter of a panel in its upper left corner, on white."""
    size = round(LETTER_SIZE * image.width)
    place, letter = (left + size // 4, top + size // 4), f'({"abcdefgh"[index]})'
    box = ImageDraw.Draw(image).textbbox(place, letter, text_font(size, is_bold=True), 'la')
    ImageDraw.Draw(image).rectangle([left, top, box[2] + size // 4, box[3] + size // 4], WHITE)
    write_text(image, place, letter, INK, 'la', size, is_bold=True)


def to_image(panels, width, height, columns=None, gap=0.02):
    """Panels in rows of `columns`, or side by side, with letters if there are several."""
    columns = columns or len(panels)
    rows = -(-len(panels) // columns)
    share, part = (round(n * (1 - gap * width / n * (k - 1)) / k) for n, k in ((width, columns), (height, rows)))
    result = np.ones((height, width, 3))
    corners = [(round(i % columns * (share + gap * width)), round(i // columns * (part + gap * width)))
               for i in range(len(panels))]
    above = round(1.8 * LETTER_SIZE * width) if any(panel.text for panel in panels) else 0  # for letters and titles
    boxes = [(left, top + above, min(share, width - left), min(part, height - top) - above) for left, top in corners]
    for panel, (left, top, wide, high) in zip(panels, boxes):
        result[top:top + high, left:left + wide] = panel.picture(wide, high)
    image = Image.fromarray((255 * result + 0.5).astype(np.uint8))
    for i, (panel, box) in enumerate(zip(panels, boxes)):
        annotate(image, panel, *box)
        if len(panels) > 1:
            add_letter(image, i, box[0], box[1] - above)
    return image


def write_picture(path, image):
    """WebP takes a fifth of a PNG, with no difference that is visible; the small picture of the overview is a PNG."""
    if path.suffix == '.png':
        image.convert('RGB').save(path, optimize=True)
    else:
        save_small(path, image.convert('RGB'), method=6)


def save_small(path, image, **options):
    """Saves as WebP, in the best quality in which the file is not too large."""
    for quality in range(88, 40, -4):
        image.save(path, quality=quality, **options)
        if path.stat().st_size <= MOST_BYTES:
            break


def size_of(points):
    """The diagonal of the box about some points."""
    return math.dist([min(p[i] for p in points) for i in range(3)], [max(p[i] for p in points) for i in range(3)])
