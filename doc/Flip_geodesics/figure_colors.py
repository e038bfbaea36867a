# SPDX-License-Identifier: LGPL-3.0-or-later
"""The colors of all figures of the manual, from a set that the color-blind can distinguish [Okabe and Ito]."""

START = '#e08a00'  # initial curves, dashed
RESULT = '#0067b0'  # results
FIXED = '#c8102e'  # points that stay in place
SECOND = '#00855f'  # a second result, and edges that were flipped
THIRD = '#a3508f'  # a third result
FOURTH = '#56b4e9'  # and so on
FIFTH = '#7a4b1f'
SURFACE = '#e9e6df'
INK = '#4a4f57'
MESH = '#aaaeb4'  # edges in the background
WHITE = '#ffffff'
