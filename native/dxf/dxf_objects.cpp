// SPDX-License-Identifier: GPL-3.0-or-later
#include "dxf/dxf_objects.h"

#include <dl_writer_ascii.h>

#include <vector>

namespace hull::dxf {
namespace {

// Handles below 0x30, which dxflib does not give to anything else; those of the layouts and of the
// records of their blocks are in writeBlockRecord().
enum Handle {
  kNone = 0x0,
  kRoot = 0xC,
  kGroups = 0xD,
  kPlotStyles = 0xE,
  kNormalPlotStyle = 0xF,
  kMultilineStyles = 0x17,
  kStandardMultiline = 0x18,
  kPlotSettings = 0x19,
  kLayouts = 0x1A,
  kPaperRecord = 0x1B,
  kPaperLayout = 0x1E,
  kModelRecord = 0x1F,
  kModelLayout = 0x22,
  kSecondPaperRecord = 0x23,
  kSecondPaperLayout = 0x26
};

struct Entry {
  const char* name;
  Handle object;
};

void begin_object(DL_WriterA& file, const char* type, Handle handle, Handle owner) {
  file.dxfString(0, type);
  file.dxfHex(5, handle);
  file.dxfHex(330, owner);
}

void write_entries(DL_WriterA& file, const std::vector<Entry>& entries) {
  file.dxfString(100, "AcDbDictionary");
  file.dxfInt(281, 1);  // of two of one name the first is kept
  for (const Entry& entry : entries) {
    file.dxfString(3, entry.name);
    file.dxfHex(350, entry.object);
  }
}

void write_dictionary(DL_WriterA& file, Handle handle, Handle owner,
                      const std::vector<Entry>& entries) {
  begin_object(file, "DICTIONARY", handle, owner);
  write_entries(file, entries);
}

void write_plot_styles(DL_WriterA& file) {
  begin_object(file, "ACDBDICTIONARYWDFLT", kPlotStyles, kRoot);
  write_entries(file, {{"Normal", kNormalPlotStyle}});
  file.dxfString(100, "AcDbDictionaryWithDefault");
  // The default is the one entry itself.
  file.dxfHex(340, kNormalPlotStyle);
  begin_object(file, "ACDBPLACEHOLDER", kNormalPlotStyle, kPlotStyles);
}

void write_standard_multiline(DL_WriterA& file) {
  constexpr int kByLayer = 256;
  begin_object(file, "MLINESTYLE", kStandardMultiline, kMultilineStyles);
  file.dxfString(100, "AcDbMlineStyle");
  file.dxfString(2, "STANDARD");
  file.dxfInt(70, 0);
  file.dxfString(3, "");
  file.dxfInt(62, kByLayer);
  // The caps are square, at 90 degrees; the two lines half a unit to either side.
  file.dxfReal(51, 90.0);
  file.dxfReal(52, 90.0);
  file.dxfInt(71, 2);
  for (const double offset : {0.5, -0.5}) {
    file.dxfReal(49, offset);
    file.dxfInt(62, kByLayer);
    file.dxfString(6, "BYLAYER");
  }
}

struct Layout {
  const char* name;
  Handle handle, record;
  int tab;
};

// What a layout says of plotting: nothing is set up, 1:1.
void write_page(DL_WriterA& file, bool is_model) {
  // The flags are a standard scale (16), plotted with plot styles (32) and line weights (128), and
  // viewports drawn first (512).
  constexpr int kPlotFlags = 688, kModelType = 1024;
  file.dxfString(100, "AcDbPlotSettings");
  file.dxfString(1, "");
  file.dxfString(2, "none_device");
  file.dxfString(4, "");
  file.dxfString(6, "");
  // Margins, size of the paper, origin and window (40 to 49, 140, 141): all nothing. The scale
  // (142, 143) is 1 to 1.
  for (int code = 40; code <= 49; ++code) file.dxfReal(code, 0.0);
  for (int code : {140, 141}) file.dxfReal(code, 0.0);
  for (int code : {142, 143}) file.dxfReal(code, 1.0);
  file.dxfInt(70, is_model ? kPlotFlags | kModelType : kPlotFlags);
  for (int code : {72, 73}) file.dxfInt(code, 0);
  // Model space plots what the screen shows (0), scaled to fit (75: 0); a layout itself (5) at 1:1
  // (16).
  file.dxfInt(74, is_model ? 0 : 5);
  file.dxfString(7, "");
  file.dxfInt(75, is_model ? 0 : 16);
  file.dxfReal(147, 1.0);
  file.dxfReal(148, 0.0);
  file.dxfReal(149, 0.0);
}

void write_point(DL_WriterA& file, int code, double x, double y) {
  file.dxfReal(code, x);
  file.dxfReal(code + 10, y);
}

void write_point(DL_WriterA& file, int code, double x, double y, double z) {
  write_point(file, code, x, y);
  file.dxfReal(code + 20, z);
}

void write_layout(DL_WriterA& file, const Layout& layout) {
  const bool is_model = layout.record == kModelRecord;
  begin_object(file, "LAYOUT", layout.handle, kLayouts);
  write_page(file, is_model);
  file.dxfString(100, "AcDbLayout");
  file.dxfString(1, layout.name);
  file.dxfInt(70, 1);
  file.dxfInt(71, layout.tab);
  // The limits, of an A3 sheet in mm.
  write_point(file, 10, 0.0, 0.0);
  write_point(file, 11, 420.0, 297.0);
  write_point(file, 12, 0.0, 0.0, 0.0);
  // A box of nothing.
  // The ends are the wrong way round, so that the first thing extended by becomes the box.
  write_point(file, 14, 1e20, 1e20, 1e20);
  write_point(file, 15, -1e20, -1e20, -1e20);
  file.dxfReal(146, 0.0);
  write_point(file, 13, 0.0, 0.0, 0.0);
  write_point(file, 16, 1.0, 0.0, 0.0);
  write_point(file, 17, 0.0, 1.0, 0.0);
  file.dxfInt(76, 0);
  file.dxfHex(330, layout.record);
}

}  // namespace

void write_dxf_objects(DL_WriterA& file) {
  file.sectionObjects();
  write_dictionary(file, kRoot, kNone,
                   {{"ACAD_GROUP", kGroups},
                    {"ACAD_LAYOUT", kLayouts},
                    {"ACAD_MLINESTYLE", kMultilineStyles},
                    {"ACAD_PLOTSETTINGS", kPlotSettings},
                    {"ACAD_PLOTSTYLENAME", kPlotStyles}});
  write_dictionary(file, kGroups, kRoot, {});
  write_plot_styles(file);
  write_dictionary(file, kMultilineStyles, kRoot, {{"Standard", kStandardMultiline}});
  write_standard_multiline(file);
  write_dictionary(file, kPlotSettings, kRoot, {});
  const Layout layouts[] = {{"Layout1", kPaperLayout, kPaperRecord, 1},
                            {"Layout2", kSecondPaperLayout, kSecondPaperRecord, 2},
                            {"Model", kModelLayout, kModelRecord, 0}};
  std::vector<Entry> entries;
  for (const Layout& layout : layouts) entries.push_back({layout.name, layout.handle});
  write_dictionary(file, kLayouts, kRoot, entries);
  for (const Layout& layout : layouts) write_layout(file, layout);
  file.sectionEnd();
}

}  // namespace hull::dxf
