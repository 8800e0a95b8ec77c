// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "drawing/cairo_handles.h"
#include "files/atomic_file.h"

namespace hull {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr double kDotsPerMm = 8.0;
constexpr double kMostDots = 5000.0;

enum class FileKind { kPdf, kSvg, kPng };

struct Colour {
  double red, green, blue;
};

struct Pen {
  double width;  // mm
  Colour colour;
  std::vector<double> dashes;  // mm
};

// Dark enough to print well in grey, apart enough to tell the families in colour.
constexpr Colour kBlack{0.0, 0.0, 0.0};
constexpr Colour kGrey{0.42, 0.42, 0.42};
constexpr Colour kPaleGrey{0.72, 0.72, 0.72};
constexpr Colour kBlue{0.07, 0.22, 0.55};
constexpr Colour kGreen{0.03, 0.38, 0.26};
constexpr Colour kRed{0.62, 0.12, 0.10};

Pen pen_of(LineKind kind) {
  switch (kind) {
    case LineKind::kFrame:
      return {0.50, kBlack, {}};
    case LineKind::kTable:
      return {0.18, kBlack, {}};
    case LineKind::kGrid:
      return {0.10, kPaleGrey, {}};
    case LineKind::kBaseline:
      return {0.25, kBlack, {}};
    case LineKind::kCentreLine:
      return {0.13, kBlack, {6.0, 1.2, 0.8, 1.2}};
    case LineKind::kPerpendicular:
      return {0.18, kBlack, {4.0, 1.0, 0.6, 1.0}};
    case LineKind::kDesignWaterline:
      return {0.30, kGreen, {}};
    case LineKind::kStation:
      return {0.20, kBlue, {}};
    case LineKind::kWaterline:
      return {0.20, kGreen, {}};
    case LineKind::kLoadWaterline:
      return {0.40, kGreen, {}};
    case LineKind::kButtock:
      return {0.20, kRed, {}};
    case LineKind::kKnuckle:
      return {0.32, kBlack, {}};
    case LineKind::kOutline:
      return {0.45, kBlack, {}};
    case LineKind::kLeader:
      return {0.10, kGrey, {}};
  }
  throw std::logic_error("a kind of line without a pen");
}

Colour colour_of(Ink ink) {
  switch (ink) {
    case Ink::kBlack:
      return kBlack;
    case Ink::kGrey:
      return kGrey;
    case Ink::kStation:
      return kBlue;
    case Ink::kWaterline:
      return kGreen;
    case Ink::kButtock:
      return kRed;
  }
  throw std::logic_error("an ink without a colour");
}

FileKind kind_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".pdf") return FileKind::kPdf;
  if (extension == ".svg") return FileKind::kSvg;
  if (extension == ".png") return FileKind::kPng;
  throw std::invalid_argument("A drawing cannot be written to \"" + path +
                              "\": the name must end in .pdf, .svg or .png");
}

cairo_status_t append_bytes(void* bytes, const unsigned char* data, unsigned int length) {
  try {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status, const std::string& path) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error("Cannot draw \"" + path + "\": " + cairo_status_to_string(status));
  }
}

double dots_per_mm(const Sheet& sheet) {
  return std::min(kDotsPerMm, kMostDots / std::max(sheet.width, sheet.height));
}

CairoSurface make_surface(const Sheet& sheet, FileKind kind, std::string& bytes) {
  const double width = sheet.width * kPointsPerMm;
  const double height = sheet.height * kPointsPerMm;
  switch (kind) {
    case FileKind::kPdf: {
      CairoSurface surface(
          cairo_pdf_surface_create_for_stream(append_bytes, &bytes, width, height));
      cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, sheet.title.c_str());
      return surface;
    }
    case FileKind::kSvg: {
      CairoSurface surface(
          cairo_svg_surface_create_for_stream(append_bytes, &bytes, width, height));
      cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PT);
      return surface;
    }
    case FileKind::kPng: {
      const double dots = dots_per_mm(sheet);
      return CairoSurface(cairo_image_surface_create(
          CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(sheet.width * dots)),
          static_cast<int>(std::lround(sheet.height * dots))));
    }
  }
  throw std::logic_error("a kind of file without a surface");
}

// Device units per millimetre.
double unit_scale(const Sheet& sheet, FileKind kind) {
  return kind == FileKind::kPng ? dots_per_mm(sheet) : kPointsPerMm;
}

void set_colour(cairo_t* context, const Colour& colour) {
  cairo_set_source_rgb(context, colour.red, colour.green, colour.blue);
}

void draw_stroke(cairo_t* context, const Stroke& stroke) {
  const Pen pen = pen_of(stroke.kind);
  set_colour(context, pen.colour);
  cairo_set_line_width(context, pen.width);
  cairo_set_dash(context, pen.dashes.data(), static_cast<int>(pen.dashes.size()), 0.0);
  const bool closed = stroke.points.size() > 2 && stroke.points.front() == stroke.points.back();
  cairo_new_path(context);
  for (const Vector2d& point : stroke.points) cairo_line_to(context, point.x(), point.y());
  if (closed) cairo_close_path(context);
  cairo_stroke(context);
}

void fill_box(cairo_t* context, const OrientedBox& box) {
  cairo_new_path(context);  // a text leaves its end as the current point
  for (const Vector2d& corner : box.corners()) cairo_line_to(context, corner.x(), corner.y());
  cairo_close_path(context);
  cairo_fill(context);
}

void draw_label(cairo_t* context, const Label& label) {
  if (label.knockout) {
    cairo_set_source_rgb(context, 1.0, 1.0, 1.0);
    fill_box(context, label.box.grown(0.25));
  }
  cairo_save(context);
  cairo_translate(context, label.box.centre.x(), label.box.centre.y());
  cairo_rotate(context, label.box.angle);
  set_colour(context, colour_of(label.ink));
  select_face(context, label.size, label.bold);
  cairo_move_to(context, -label.box.half.x(), label.box.half.y() - label.descent);
  cairo_show_text(context, label.text.c_str());
  cairo_restore(context);
}

void draw_sheet(cairo_t* context, const Sheet& sheet) {
  cairo_set_source_rgb(context, 1.0, 1.0, 1.0);
  cairo_paint(context);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
  for (const Stroke& stroke : sheet.strokes) draw_stroke(context, stroke);
  set_colour(context, kBlack);
  for (const AlignedBox2d& patch : sheet.patches) {
    cairo_rectangle(context, patch.min().x(), patch.min().y(), patch.sizes().x(),
                    patch.sizes().y());
    cairo_fill(context);
  }
  for (const Label& label : sheet.labels) draw_label(context, label);
}

}  // namespace

void check_drawing_path(const std::string& path) { kind_of(path); }

void write_sheet(const Sheet& sheet, const std::string& path) {
  const FileKind kind = kind_of(path);
  std::string bytes;
  const CairoSurface surface = make_surface(sheet, kind, bytes);
  check(cairo_surface_status(surface.get()), path);
  {
    const CairoContext context(cairo_create(surface.get()));
    const double scale = unit_scale(sheet, kind);
    cairo_scale(context.get(), scale, scale);
    draw_sheet(context.get(), sheet);
    cairo_show_page(context.get());
    check(cairo_status(context.get()), path);
  }
  if (kind == FileKind::kPng) {
    check(cairo_surface_write_to_png_stream(surface.get(), append_bytes, &bytes), path);
  }
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()), path);
  write_file_atomically(path, bytes);
}

}  // namespace hull
