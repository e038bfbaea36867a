# SPDX-License-Identifier: LGPL-3.0-or-later
"""Pictures to be laid on surfaces. They have the surface's color at their borders, which goes on beyond them."""

import math

from figure_colors import FIXED, RESULT, SECOND, SURFACE, WHITE
from PIL import Image, ImageDraw


def disk(draw, middle, radius, name):
    draw.ellipse([middle - radius, middle - radius, middle + radius, middle + radius], name)


def compass(pixels=1024):
    """A picture for a decal: a rose of eight points in three rings, with red in the middle."""
    picture = Image.new('RGB', (pixels, pixels), SURFACE)
    draw = ImageDraw.Draw(picture)

    def at(radius, eighth):
        angle = math.pi / 4 * eighth
        return pixels * (0.5 + radius * math.sin(angle)), pixels * (0.5 - radius * math.cos(angle))

    for radius, name in ((0.485, RESULT), (0.455, WHITE), (0.35, SECOND), (0.335, WHITE)):
        disk(draw, pixels / 2, pixels * radius, name)
    for tick in range(32):
        draw.line([at(0.405 if tick % 4 else 0.36, tick / 4), at(0.46, tick / 4)], RESULT, pixels // 128)
    for first, length, waist in ((1, 0.31, 0.14), (0, 0.44, 0.11)):
        for k in range(first, 8, 2):
            for side, name in ((-0.5, RESULT), (0.5, WHITE)):
                draw.polygon([at(0, 0), at(waist, k + side), at(length, k)], name, RESULT, pixels // 256)
    disk(draw, pixels / 2, pixels * 0.035, FIXED)
    return picture


def checker(squares, pixels=1024):
    """A picture for a decal: a checkered board with a red middle."""
    picture = Image.new('RGB', (pixels, pixels), SURFACE)
    draw = ImageDraw.Draw(picture)
    side = (pixels - 8) / squares
    for i in range(squares):
        for j in range(squares):
            draw.rectangle([4 + i * side, 4 + j * side, 4 + (i + 1) * side, 4 + (j + 1) * side],
                           RESULT if (i + j) % 2 else WHITE)
    disk(draw, pixels / 2, side / 3, FIXED)
    return picture
