# SPDX-License-Identifier: LGPL-3.0-or-later
"""Light for pictures: from a sky of many lamps, from a sun with a soft shadow, and a white ground that takes shadows.

What a lamp sees is a picture of depths; a place is lit by it where it lies no deeper than that. VTK draws the depths,
NumPy compares. All numbers are parts of the size of what is drawn.
"""

import math

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

SKY, SUN = 72, 16      # lamps of each
SUN_RADIUS = 0.11      # of the disk about the sun's direction from which its lamps shine, which softens shadows
DEPTH_PIXELS = 640, 1024  # of what a lamp sees, in each direction: one of the sky, and one of the sun
BIAS = 6.0             # pixels, as far behind what a lamp sees a place is still lit


def unit(v):
    v = np.asarray(v, float)
    return v / np.linalg.norm(v)


def frame(direction):
    """Two directions that are orthogonal to one and to each other."""
    axis = np.eye(3)[np.argmin(np.abs(direction))]
    first = unit(np.cross(axis, direction))
    return first, np.cross(direction, first)


def sunflower(count):
    """Points that fill the unit disk evenly."""
    k = np.arange(count) + 0.5
    angle, radius = k * math.pi * (3 - math.sqrt(5)), np.sqrt(k / count)
    return np.stack([radius * np.cos(angle), radius * np.sin(angle)], axis=1)


def sky_lamps(up):
    """Directions with equal shares of the light of an overcast sky that falls on the ground."""
    x, y = frame(up)
    return [a * x + b * y + math.sqrt(max(0.0, 1 - a * a - b * b)) * up for a, b in sunflower(SKY)]


def sun_lamps(direction):
    x, y = frame(direction)
    return [unit(direction + SUN_RADIUS * (a * x + b * y)) for a, b in sunflower(SUN)]


class Stage:
    """A renderer with its window, off the screen, from which colors and depths are read."""

    def __init__(self, renderer):
        self.renderer = renderer
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SwapBuffersOff()
        self.window.AddRenderer(renderer)
        renderer.AutomaticLightCreationOff()

    def close(self):
        self.window.RemoveRenderer(self.renderer)
        self.window.Finalize()

    def _read(self, camera, width, height, is_depth):
        self.renderer.SetActiveCamera(camera)
        self.window.SetSize(width, height)
        self.window.Render()
        image = vtk.vtkWindowToImageFilter()
        image.SetInput(self.window)
        image.ReadFrontBufferOff()
        image.ShouldRerenderOff()
        if is_depth:
            image.SetInputBufferTypeToZBuffer()
        image.Update()
        data = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())
        return data.reshape((height, width) if is_depth else (height, width, 3)).astype(np.float32)

    def colors(self, camera, width, height):
        return self._read(camera, width, height, False) / 255

    def depths(self, camera, width, height):
        return self._read(camera, width, height, True)


def bounding_sphere(renderer):
    bounds = renderer.ComputeVisiblePropBounds()
    center = np.array([(bounds[i] + bounds[i + 1]) / 2 for i in (0, 2, 4)])
    return center, math.dist(bounds[0::2], bounds[1::2]) / 2


def seen_by(stage, lamps, places, center, radius, pixels):
    """For each place the share of the lamps that see it."""
    camera = vtk.vtkCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(radius)
    camera.SetClippingRange(radius, 3 * radius)
    camera.SetFocalPoint(*center)
    result = np.zeros(len(places), np.float32)
    shifted = ((places - center) / radius).astype(np.float32)
    last = pixels - 1
    for lamp in lamps:
        x, y = frame(lamp)
        camera.SetPosition(*(center + 2 * radius * lamp))
        camera.SetViewUp(*y)
        depths = 1 - 2 * stage.depths(camera, pixels, pixels).ravel()  # heights towards the lamp
        u = ((shifted @ x.astype(np.float32) + 1) * (pixels / 2)).astype(np.int32)
        v = ((shifted @ y.astype(np.float32) + 1) * (pixels / 2)).astype(np.int32)
        is_inside = (u >= 0) & (u <= last) & (v >= 0) & (v <= last)
        heights = depths[np.clip(v, 0, last) * pixels + np.clip(u, 0, last)]
        above = (shifted @ lamp.astype(np.float32) - heights) / (2 * BIAS / pixels) + 1.5  # 1 from half the bias on
        result += np.where(is_inside, np.clip(above, 0, 1), 1)
    return result / len(lamps)


def places_of(camera, depths, aspect):
    """The place in space of each pixel of a picture with depths, by a camera with parallel projection; and its rays."""
    height, width = depths.shape
    focus, eye = np.array(camera.GetFocalPoint()), np.array(camera.GetPosition())
    towards = unit(eye - focus)
    right = unit(np.cross(camera.GetViewUp(), towards))
    up = np.cross(towards, right)
    scale = camera.GetParallelScale()
    near, far = camera.GetClippingRange()
    u = (np.arange(width) + 0.5) / width * 2 - 1
    v = (np.arange(height) + 0.5) / height * 2 - 1
    plane = (eye + scale * (aspect * u[None, :, None] * right + v[:, None, None] * up)).reshape(-1, 3)
    return plane - (near + (far - near) * depths.reshape(-1, 1)) * towards, towards


def light(stage, camera, width, height, up, sun, flatness, blur):
    """A picture of what is on a stage, numbers from 0 to 1. `up` is the direction from the ground, None for no ground;
    `sun` the sun's direction. `flatness` has a number from 0 to 1 per actor: how far its own color is kept in shadows.
    Light on surfaces is smoothed over `blur` pixels."""
    albedo, lamp_lit = base_and_sun(stage, camera, width, height, sun)
    flat = levels(stage, camera, width, height, flatness)
    depths = stage.depths(camera, width, height)
    center, radius = bounding_sphere(stage.renderer)
    places, towards = places_of(camera, depths, width / height)
    is_ground = (depths >= 1).ravel()
    has_ground = up is not None and float(np.dot(up, towards)) > 0.03
    if has_ground:
        lowest = lowest_height(stage.renderer, up)
        places[is_ground] -= ((places[is_ground] @ up - lowest) / np.dot(towards, up))[:, None] * towards
    zenith = up if up is not None else towards
    wanted, of_pixel = samples(depths, np.full(depths.shape, True) if has_ground else depths < 1)
    lamps = sky_lamps(unit(0.8 * zenith + 0.6 * towards)), sun_lamps(sun)
    sky, shine = (np.append(seen_by(stage, group, places[wanted], center, radius, pixels), 1)[of_pixel]
                  for group, pixels in zip(lamps, DEPTH_PIXELS))
    is_ground = is_ground.reshape(depths.shape)
    sky, shine = (np.where(is_ground, smooth_where(is_ground, lights, width // 120),
                           smooth_where(~is_ground, lights, blur)) for lights in (sky, shine))
    dark, sky_share, sun_share = 0.22 + 0.40 * flat, 0.46 - 0.24 * flat, 0.36 - 0.10 * flat
    lit = (albedo * (dark + sky_share * sky[..., None]) + sun_share * lamp_lit * shine[..., None]) ** 0.9
    ground = 1 - (0.5 * np.clip(0.85 - sky, 0, 1) + 0.15 * (1 - shine)) * fading(width, height)
    return np.where(is_ground[..., None], ground[..., None], np.clip(lit, 0, 1))


def samples(depths, is_wanted):
    """The pixels of which light is computed, and for each pixel the position among these, or -1. Pixels that become one
    share their light unless they are of different depths."""
    height, width = depths.shape
    blocks = depths.reshape(height // 2, 2, width // 2, 2)
    is_mixed = blocks.max(axis=(1, 3)) - blocks.min(axis=(1, 3)) > 0.004
    is_mixed = is_mixed.repeat(2, axis=0).repeat(2, axis=1)
    rows, columns = np.indices(depths.shape, sparse=True)
    pixel = np.where(is_mixed, rows * width + columns, (rows - rows % 2) * width + columns - columns % 2)
    wanted, of_pixel = np.unique(np.where(is_wanted, pixel, -1), return_inverse=True)
    has_none = int(wanted[0] == -1)
    return wanted[has_none:], of_pixel.reshape(depths.shape) - has_none


def blurred(values, radius):
    """The means over squares, twice."""
    for axis in (0, 1, 0, 1):
        values = np.moveaxis(values, axis, 0)
        sums = np.cumsum(np.pad(values, [(radius + 1, radius), (0, 0)], mode='edge'), axis=0, dtype=np.float64)
        values = np.moveaxis((sums[2 * radius + 1:] - sums[:len(values)]) / (2 * radius + 1), 0, axis)
    return values


def smooth_where(is_wanted, values, radius):
    """Means over what is wanted, which hides how few the lamps are."""
    return blurred(values * is_wanted, radius) / np.maximum(blurred(1.0 * is_wanted, radius), 1e-6)


def fading(width, height):
    """1 in the middle of a picture, 0 at its borders, without corners."""
    x, y = (np.abs(np.arange(n) + 0.5 - n / 2) * 2 / n for n in (width, height))
    t = np.clip((1 - (x[None, :] ** 3 + y[:, None] ** 3) ** (1 / 3)) / 0.4, 0, 1)
    return t * t * (3 - 2 * t)


def points_of(actor):
    return vtk_to_numpy(actor.GetMapper().GetInput().GetPoints().GetData())


def lowest_height(renderer, up):
    lowest = math.inf
    for actor in renderer.GetActors():
        lowest = min(lowest, float((points_of(actor) @ up).min()))
    return lowest


def levels(stage, camera, width, height, numbers):
    """A picture of the numbers of the actors."""
    before = []
    for actor in stage.renderer.GetActors():
        look, mapper = actor.GetProperty(), actor.GetMapper()
        before.append((actor, look.GetColor(), actor.GetTexture(), mapper.GetScalarVisibility()))
        look.SetColor(3 * [numbers[actor]])
        look.SetAmbient(1)
        look.SetDiffuse(0)
        actor.SetTexture(None)
        mapper.ScalarVisibilityOff()
    result = stage.colors(camera, width, height)
    for actor, color, texture, has_scalars in before:
        actor.GetProperty().SetColor(color)
        actor.SetTexture(texture)
        actor.GetMapper().SetScalarVisibility(has_scalars)
    return result


def base_and_sun(stage, camera, width, height, sun):
    """The colors by themselves, and as the sun lights them where nothing is in its way."""
    pictures = []
    stage.renderer.RemoveAllLights()
    lamp = vtk.vtkLight()
    lamp.SetLightTypeToSceneLight()
    lamp.SetPositional(0)
    lamp.SetFocalPoint(0, 0, 0)
    lamp.SetPosition(*sun)
    stage.renderer.AddLight(lamp)
    for ambient, diffuse in ((1, 0), (0, 1)):
        for actor in stage.renderer.GetActors():
            actor.GetProperty().SetAmbient(ambient)
            actor.GetProperty().SetDiffuse(diffuse)
        pictures.append(stage.colors(camera, width, height))
    return pictures
