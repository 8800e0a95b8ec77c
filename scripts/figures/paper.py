# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings in mm on white paper, as PDF and PNG; pictures put on a page, together, made small."""

import math

import cairo
import numpy as np

FONT = "DejaVu Sans"
DOTS_PER_MM = 8.0
_POINTS_PER_MM = 72.0 / 25.4
# Of 255: how far the background's colour goes within a row.
_BACKGROUND = 10
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


def picture_to_pdf(png, pdf, width=297.0):
    """A page of that width in mm that a picture fills."""
    image = cairo.ImageSurface.create_from_png(str(png))
    scale = width * _POINTS_PER_MM / image.get_width()
    page = cairo.PDFSurface(str(pdf), width * _POINTS_PER_MM, image.get_height() * scale)
    _put(page, image, scale)
    page.finish()


def make_small(png, small, width):
    """A copy that is `width` dots wide, or as wide as the picture where that is less."""
    image = cairo.ImageSurface.create_from_png(str(png))
    scale = min(width / image.get_width(), 1.0)
    copy = _white(image.get_width() * scale, image.get_height() * scale)
    _put(copy, image, scale)
    copy.write_to_png(str(small))


def put_below(pngs, together, margin=24):
    """One picture of several, one below the other, without rows of the background above and below
    but for a margin."""
    images = [cairo.ImageSurface.create_from_png(str(png)) for png in pngs]
    rows = [_rows_with_content(image, margin) for image in images]
    page = _white(max(image.get_width() for image in images), sum(b - a for a, b in rows))
    top = 0
    for image, (first, last) in zip(images, rows):
        context = cairo.Context(page)
        context.rectangle(0, top, image.get_width(), last - first)
        context.clip()
        context.set_source_surface(image, 0, top - first)
        context.paint()
        top += last - first
    page.write_to_png(str(together))


def _rows_with_content(image, margin):
    """(first, last + 1) of the rows that are not all of the background's colour, and a margin."""
    height, width, stride = image.get_height(), image.get_width(), image.get_stride()
    pixels = np.frombuffer(image.get_data(), dtype=np.uint8).reshape(height, stride // 4, 4)
    pixels = pixels[:, :width, :3].astype(int)
    rows = np.flatnonzero((np.abs(pixels - pixels[:, :1]) > _BACKGROUND).any(axis=(1, 2)))
    if not len(rows):
        return 0, height
    return max(int(rows[0]) - margin, 0), min(int(rows[-1]) + 1 + margin, height)


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
