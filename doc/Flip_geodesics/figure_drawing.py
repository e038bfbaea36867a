# SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws surfaces and curves with VTK, without a screen, into PNG files."""

import math

import vtk
from PIL import Image

BLUE, RED, GREEN, ORANGE = '#0b4fb3', '#c2121b', '#0a7a3d', '#d97700'
SURFACE, INK, WHITE = '#d8dce3', '#3a434d', '#ffffff'


def color(name):
    """The parts of '#rrggbb', from 0 to 1."""
    return tuple(int(name[i:i + 2], 16) / 255 for i in (1, 3, 5))


def poly_data(points, faces=(), lines=()):
    data, places = vtk.vtkPolyData(), vtk.vtkPoints()
    places.SetDataTypeToDouble()
    for p in points:
        places.InsertNextPoint(p)
    data.SetPoints(places)
    for cells, use in ((faces, data.SetPolys), (lines, data.SetLines)):
        array = vtk.vtkCellArray()
        for cell in cells:
            array.InsertNextCell(len(cell))
            for i in cell:
                array.InsertCellPoint(i)
        use(array)
    return data


def polyline_data(polylines):
    points, lines = [], []
    for line in polylines:
        lines.append(range(len(points), len(points) + len(line)))
        points += line
    return poly_data(points, lines=lines)


class Panel:
    """A part of a picture with a camera of its own. Widths and radii are parts of the size of what is drawn."""

    def __init__(self, size):
        self.size = size
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
        self.renderer.AddActor(actor)
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
        actor.GetProperty().SetAmbient(0.25)
        actor.GetProperty().SetDiffuse(0.75)
        return actor

    def colored_surface(self, points, faces, values, colors):
        """A smooth surface with a number per point. `colors`: pairs of a number and a color, in order."""
        data = poly_data(points, faces)
        array = vtk.vtkDoubleArray()
        for value in values:
            array.InsertNextValue(value)
        data.GetPointData().SetScalars(array)
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
        actor.GetProperty().SetAmbient(0.25)
        actor.GetProperty().SetDiffuse(0.75)
        return actor

    def tubes(self, polylines, name, width):
        tubes = vtk.vtkTubeFilter()
        tubes.SetInputData(polyline_data([line for line in polylines if len(line) > 1]))
        tubes.SetRadius(width / 2 * self.size)
        tubes.SetNumberOfSides(10)
        tubes.CappingOn()
        actor = self._add(tubes, name)
        actor.GetProperty().SetAmbient(0.45)
        actor.GetProperty().SetDiffuse(0.6)
        return actor

    def contours(self, points, faces, values, levels, name, width):
        """The lines on a surface where a number per point has certain levels, as tubes."""
        data = poly_data(points, faces)
        array = vtk.vtkDoubleArray()
        for value in values:
            array.InsertNextValue(value)
        data.GetPointData().SetScalars(array)
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
        tubes.SetNumberOfSides(8)
        actor = self._add(tubes, name)
        actor.GetProperty().SetAmbient(0.45)
        actor.GetProperty().SetDiffuse(0.6)
        return actor

    def edges(self, points, faces, name=INK, width=0.0012):
        """The edges of some triangles as thin tubes."""
        pairs = {tuple(sorted((f[i], f[i - 1]))) for f in faces for i in range(len(f))}
        return self.tubes([[points[a], points[b]] for a, b in sorted(pairs)], name, width)

    def balls(self, points, name, width):
        ball = vtk.vtkSphereSource()
        ball.SetRadius(width / 2 * self.size)
        ball.SetThetaResolution(24)
        ball.SetPhiResolution(24)
        glyphs = vtk.vtkGlyph3D()
        glyphs.SetInputData(poly_data(points))
        glyphs.SetSourceConnection(ball.GetOutputPort())
        glyphs.ScalingOff()
        actor = self._add(glyphs, name)
        actor.GetProperty().SetAmbient(0.45)
        actor.GetProperty().SetDiffuse(0.6)
        return actor

    def look(self, direction, up=(0, 1, 0), target=None, zoom=1.0):
        """Looks from `direction` at everything, or at `target` so much closer than that."""
        camera = self.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(0, 0, 0)
        away = 3 * self.size / math.hypot(*direction)  # outside of everything
        camera.SetPosition(*(away * x for x in direction))
        camera.SetViewUp(*up)
        self.target, self.zoom = target, zoom

    def fit(self, aspect):
        """Moves the camera so that what is drawn just fits into a panel of this width over height."""
        camera = self.renderer.GetActiveCamera()
        to_view = camera.GetViewTransformMatrix()
        seen = [[math.inf, -math.inf] for _ in range(3)]
        for actor in self.renderer.GetActors():
            actor.GetMapper().Update()
            data = actor.GetMapper().GetInput()
            for i in range(data.GetNumberOfPoints()):
                place = to_view.MultiplyPoint((*data.GetPoint(i), 1))
                for bounds, x in zip(seen, place):
                    bounds[0], bounds[1] = min(bounds[0], x), max(bounds[1], x)
        middle = [(a + b) / 2 for a, b in seen]
        back = vtk.vtkMatrix4x4()
        vtk.vtkMatrix4x4.Invert(to_view, back)
        focus = self.target or back.MultiplyPoint((*middle, 1))[:3]
        move = [f - g for f, g in zip(focus, camera.GetFocalPoint())]
        camera.SetPosition(*(p + m for p, m in zip(camera.GetPosition(), move)))
        camera.SetFocalPoint(*focus)
        half = max((seen[1][1] - seen[1][0]) / 2, (seen[0][1] - seen[0][0]) / 2 / aspect)
        camera.SetParallelScale(1.03 * half / self.zoom)
        self.renderer.ResetCameraClippingRange()
        self._add_lamps()

    def _add_lamps(self):
        self.renderer.RemoveAllLights()
        for place, strength in (((-0.6, 0.9, 1.2), 0.85), ((0.9, -0.2, 0.8), 0.3)):
            lamp = vtk.vtkLight()
            lamp.SetLightTypeToCameraLight()
            lamp.SetPosition(*place)
            lamp.SetFocalPoint(0, 0, 0)
            lamp.SetIntensity(strength)
            self.renderer.AddLight(lamp)


def write_png(path, panels, width, height):
    """Writes panels side by side. They are drawn at three times the size, which smooths all edges."""
    oversampling, gap = 3, 0.02
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(oversampling * width, oversampling * height)
    share = (1 - gap * (len(panels) - 1)) / len(panels)
    for i, panel in enumerate(panels):
        left = i * (share + gap)
        panel.renderer.SetViewport(left, 0, left + share, 1)
        panel.fit(share * width / height)
        window.AddRenderer(panel.renderer)
    behind = vtk.vtkRenderer()
    behind.SetBackground(1, 1, 1)
    window.AddRenderer(behind)
    behind.SetLayer(0)
    window.SetNumberOfLayers(2)
    for panel in panels:
        panel.renderer.SetLayer(1)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    mean = vtk.vtkImageShrink3D()
    mean.SetInputConnection(image.GetOutputPort())
    mean.SetShrinkFactors(oversampling, oversampling, 1)
    mean.AveragingOn()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(mean.GetOutputPort())
    writer.Write()
    make_small(path)


def make_small(path):
    """Keeps 256 colors of a PNG file, which is enough for a few lit materials. A fifth of them are for what has much
    color, since curves have few pixels. Colored surfaces are dithered."""
    with Image.open(path) as file:
        image = file.convert('RGB')
    pixels = list(image.getdata())
    bright = [p for p in pixels if max(p) - min(p) > 50]
    if len(bright) > len(pixels) / 10:
        image.quantize(palette=image.quantize(256)).save(path, optimize=True)
        return
    palette = image.quantize(200, dither=Image.Dither.NONE).getpalette()[:600]
    if bright:
        row = Image.new('RGB', (len(bright), 1))
        row.putdata(bright)
        palette += row.quantize(56, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).getpalette()[:168]
    chosen = Image.new('P', (1, 1))
    chosen.putpalette(palette + [0] * (768 - len(palette)))
    image.quantize(palette=chosen, dither=Image.Dither.NONE).save(path, optimize=True)


def size_of(points):
    """The diagonal of the box about some points."""
    return math.dist([min(p[i] for p in points) for i in range(3)], [max(p[i] for p in points) for i in range(3)])
