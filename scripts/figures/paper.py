# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings in mm on white paper, as PDF and PNG; pictures made small."""

import math

import cairo
import numpy as np

FONT = "DejaVu Sans"
DOTS_PER_MM = 8.0
_POINTS_PER_MM = 72.0 / 25.4
BLACK, GREY, PALE = (0.0, 0.0, 0.0), (0.45, 0.45, 0.45), (0.78, 0.78, 0.78)


def draw(stem, width, height, paint):
    """Writes `stem`.pdf and `stem`.png of what paint(context) draws: mm, y downwards."""
    pdf = cairo.PDFSurface(f"{stem}.pdf", width * _POINTS_PER_MM, height * _POINTS_PER_MM)
    _paint(pdf, _POINTS_PER_MM, paint)
    pdf.finish()
    size = math.ceil(width * DOTS_PER_MM), math.ceil(height * DOTS_PER_MM)
    png = cairo.ImageSurface(cairo.FORMAT_RGB24, *size)
    _paint(png, DOTS_PER_MM, paint)
    png.write_to_png(f"{stem}.png")


def _paint(surface, scale, paint):
    context = cairo.Context(surface)
    context.set_source_rgb(1.0, 1.0, 1.0)
    context.paint()
    context.scale(scale, scale)
    context.set_line_cap(cairo.LINE_CAP_ROUND)
    context.set_line_join(cairo.LINE_JOIN_ROUND)
    context.select_font_face(FONT)
    paint(context)


def line(context, points, width, colour, dashes=()):
    """A polyline through (n, 2) points."""
    context.set_source_rgb(*colour)
    context.set_line_width(width)
    context.set_dash(dashes)
    context.move_to(*points[0])
    for point in points[1:]:
        context.line_to(*point)
    context.stroke()


def text(context, at, words, height=3.0, colour=BLACK, align=0.5, bold=False):
    """Words on the base line at a point; align 0 begins there, 0.5 is centred, 1 ends there."""
    weight = cairo.FONT_WEIGHT_BOLD if bold else cairo.FONT_WEIGHT_NORMAL
    context.select_font_face(FONT, cairo.FONT_SLANT_NORMAL, weight)
    context.set_font_size(height)
    context.set_source_rgb(*colour)
    context.move_to(at[0] - align * text_width(context, words), at[1])
    context.show_text(words)


def text_width(context, words):
    """Of words in the letters that were used last."""
    return context.text_extents(words).x_advance


def text_width_of(context, words, height):
    context.set_font_size(height)
    return text_width(context, words)


def make_small(png, small, width):
    """A copy that is `width` dots wide, or as wide as the picture where that is less."""
    image = cairo.ImageSurface.create_from_png(str(png))
    scale = min(width / image.get_width(), 1.0)
    copy = _white(image.get_width() * scale, image.get_height() * scale)
    _put(copy, image, scale)
    copy.write_to_png(str(small))


def _white(width, height):
    surface = cairo.ImageSurface(cairo.FORMAT_RGB24, round(width), round(height))
    context = cairo.Context(surface)
    context.set_source_rgb(1.0, 1.0, 1.0)
    context.paint()
    return surface


def _put(surface, image, scale):
    context = cairo.Context(surface)
    context.scale(scale, scale)
    context.set_source_surface(image)
    context.get_source().set_filter(cairo.FILTER_BEST)
    context.paint()


def image(dots):
    """A cairo surface of colours (h, w, 3) in [0, 1]."""
    height, width = dots.shape[:2]
    stride = cairo.ImageSurface.format_stride_for_width(cairo.FORMAT_RGB24, width)
    buffer = np.zeros((height, stride), dtype=np.uint8)
    bytes_ = np.round(255.0 * np.clip(dots, 0.0, 1.0)).astype(np.uint8)
    buffer[:, : 4 * width].reshape(height, width, 4)[..., :3] = bytes_[..., ::-1]
    return cairo.ImageSurface.create_for_data(
        buffer.data, cairo.FORMAT_RGB24, width, height, stride
    )
