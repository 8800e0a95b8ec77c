// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/paper/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <tuple>

#include "drawing/paper/cairo_handles.h"
#include "files/atomic_file.h"

namespace hull::drawing {

using Eigen::Vector2d;

namespace {

// Points of 1/72 inch are what PDF and SVG count in.
constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr double kDotsPerMm = 8.0;
constexpr double kMostDots = 5000.0;

constexpr int kDashCount = static_cast<int>(std::tuple_size_v<Dashes>);

enum class FileKind { kPdf, kSvg, kPng };

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
    // An exception must not pass through Cairo, which is written in C.
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
      // The surface keeps the address of `bytes`, which has to outlive it.
      CairoSurface surface(
          cairo_pdf_surface_create_for_stream(append_bytes, &bytes, width, height));
      cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, sheet.title.c_str());
      return surface;
    }
    case FileKind::kSvg: {
      CairoSurface surface(
          cairo_svg_surface_create_for_stream(append_bytes, &bytes, width, height));
      // Else the numbers would be pixels, and the sheet not at its true size.
      cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PT);
      return surface;
    }
    case FileKind::kPng: {
      const double dots = dots_per_mm(sheet);
      // No alpha channel: the paper is filled white before anything is drawn.
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

bool is_dashed(const Dashes& dashes) { return dashes != Dashes{}; }

void set_colour(cairo_t* context, const Ink& colour) {
  cairo_set_source_rgba(context, colour.red, colour.green, colour.blue, colour.opacity);
}

template <typename Points>
void add_polygon(cairo_t* context, const Points& points) {
  cairo_new_path(context);  // a text leaves its end as the current point
  for (const Vector2d& point : points) cairo_line_to(context, point.x(), point.y());
  cairo_close_path(context);
}

void draw_stroke(cairo_t* context, const Stroke& stroke) {
  set_colour(context, stroke.pen.colour);
  cairo_set_line_width(context, stroke.pen.width);
  const Dashes& dashes = stroke.pen.dashes;
  // A pattern of zeros alone is an error, which a context keeps for good.
  cairo_set_dash(context, dashes.data(), is_dashed(dashes) ? kDashCount : 0, 0.0);
  const bool closed = stroke.points.size() > 2 && stroke.points.front() == stroke.points.back();
  cairo_new_path(context);
  // The first one moves: there is no current point after cairo_new_path().
  for (const Vector2d& point : stroke.points) cairo_line_to(context, point.x(), point.y());
  // Closed by Cairo the ends are joined round; closed by a point they would be butted.
  if (closed) cairo_close_path(context);
  cairo_stroke(context);
}

void draw_fill(cairo_t* context, const Fill& fill) {
  set_colour(context, fill.colour);
  add_polygon(context, fill.points);
  cairo_fill(context);
}

void draw_label(cairo_t* context, const Label& label) {
  if (label.knockout) {
    cairo_set_source_rgb(context, 1.0, 1.0, 1.0);
    // A little more than the text, so that the curve ends clear of its letters.
    add_polygon(context, label.box.grown(0.25).corners());
    cairo_fill(context);
  }
  cairo_save(context);
  // In the label's own frame, turned about the box's centre, the text is level.
  cairo_translate(context, label.box.centre.x(), label.box.centre.y());
  cairo_rotate(context, label.box.angle);
  set_colour(context, label.ink);
  select_face(context, label.size, label.bold);
  // A text's reference point is the left end of its baseline, which is above the box's bottom by
  // the descent.
  cairo_move_to(context, -label.box.half.x(), label.box.half.y() - label.descent);
  cairo_show_text(context, label.text.c_str());
  cairo_restore(context);
}

void draw_picture(cairo_t* context, const Picture& picture) {
  const CairoSurface image(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.columns, picture.rows));
  if (cairo_surface_status(image.get()) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
  unsigned char* const bytes = cairo_image_surface_get_data(image.get());
  const std::size_t stride = cairo_image_surface_get_stride(image.get());
  // Row by row: Cairo pads rows to its own stride.
  for (int row = 0; row < picture.rows; ++row) {
    std::memcpy(bytes + row * stride,
                picture.dots.data() + static_cast<std::size_t>(row) * picture.columns,
                sizeof(std::uint32_t) * picture.columns);
  }
  cairo_surface_mark_dirty(image.get());
  cairo_save(context);
  cairo_translate(context, picture.corner.x(), picture.corner.y());
  cairo_rectangle(context, 0.0, 0.0, picture.size.x(), picture.size.y());
  cairo_clip(context);
  cairo_scale(context, picture.size.x() / picture.columns, picture.size.y() / picture.rows);
  cairo_set_source_surface(context, image.get(), 0.0, 0.0);
  // Dots at the page's edge would else fade into what is outside.
  cairo_pattern_set_extend(cairo_get_source(context), CAIRO_EXTEND_PAD);
  cairo_paint(context);
  cairo_restore(context);
}

void draw_sheet(cairo_t* context, const Sheet& sheet) {
  cairo_set_source_rgb(context, 1.0, 1.0, 1.0);
  // PDF's and SVG's pages would else be transparent.
  cairo_paint(context);
  // Mitres of curves with sharp bends would be spikes.
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
  for (const Picture& picture : sheet.pictures) draw_picture(context, picture);
  for (const Fill& area : sheet.areas) draw_fill(context, area);
  for (const Stroke& stroke : sheet.strokes) draw_stroke(context, stroke);
  for (const Fill& patch : sheet.patches) draw_fill(context, patch);
  for (const Label& label : sheet.labels) draw_label(context, label);
}

}  // namespace

void check_drawing_path(const std::string& path) { kind_of(path); }

void write_sheet(const Sheet& sheet, const std::string& path) {
  const FileKind kind = kind_of(path);
  // Drawn to memory first, so that a failure leaves the file that was there.
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
  // An image is only dots in memory: it is made a file when all is drawn.
  if (kind == FileKind::kPng) {
    check(cairo_surface_write_to_png_stream(surface.get(), append_bytes, &bytes), path);
  }
  // PDF and SVG are complete only now, so the status that counts is the one after.
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()), path);
  files::write_file_atomically(path, bytes);
}

void write_sheets(const std::vector<Sheet>& sheets, const std::string& path) {
  if (sheets.empty() || kind_of(path) != FileKind::kPdf) {
    throw std::invalid_argument("Several sheets can only be written to a .pdf, not to \"" + path +
                                "\"");
  }
  std::string bytes;
  const CairoSurface surface = make_surface(sheets.front(), FileKind::kPdf, bytes);
  check(cairo_surface_status(surface.get()), path);
  for (const Sheet& sheet : sheets) {
    // The surface was made in the first sheet's size.
    cairo_pdf_surface_set_size(surface.get(), sheet.width * kPointsPerMm,
                               sheet.height * kPointsPerMm);
    const CairoContext context(cairo_create(surface.get()));
    cairo_scale(context.get(), kPointsPerMm, kPointsPerMm);
    draw_sheet(context.get(), sheet);
    cairo_show_page(context.get());
    check(cairo_status(context.get()), path);
  }
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()), path);
  files::write_file_atomically(path, bytes);
}

}  // namespace hull::drawing
