// SPDX-License-Identifier: Apache-2.0
// The sheet drawn by cairo, as PDF and as SVG.
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <memory>
#include <numbers>
#include <stdexcept>

#include "horopter/calib/pattern.hpp"

namespace horopter::calib {
namespace {

using Eigen::Vector2d;
using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

constexpr double kPointsPerMm = 72 / 25.4;
/// Cairo rounds what it draws to 1/256 of a surface's unit. A point is too coarse for that: the sheet is drawn on a
/// surface that is this many times finer, and that surface is put on the page.
constexpr double kFiner = 256;
/// The same sheet gives the same file.
constexpr const char* kCreationDate = "2000-01-01T00:00:00Z";

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(std::string("the sheet cannot be drawn: ") + cairo_status_to_string(status));
  }
}

void set_colour(cairo_t* context, bool black) {
  const double grey = black ? 0 : 1;
  cairo_set_source_rgb(context, grey, grey, grey);
}

void draw_text(cairo_t* context, const Pattern::Text& text) {
  cairo_save(context);
  cairo_translate(context, text.start_mm.x(), text.start_mm.y());
  if (text.upright) cairo_rotate(context, -std::numbers::pi / 2);
  cairo_select_font_face(context, "Helvetica", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, text.size_mm);
  cairo_move_to(context, 0, 0);
  cairo_show_text(context, text.words.c_str());
  cairo_restore(context);
}

/// All of the sheet, where the unit of the context is the millimetre.
void draw(cairo_t* context, const Pattern& pattern) {
  set_colour(context, false);
  cairo_rectangle(context, 0, 0, pattern.width_mm, pattern.height_mm);
  cairo_fill(context);
  for (const auto& polygon : pattern.polygons) {
    set_colour(context, polygon.black);
    for (const Vector2d& p : polygon.points_mm) cairo_line_to(context, p.x(), p.y());
    cairo_close_path(context);
    cairo_fill(context);
  }
  for (const auto& disc : pattern.discs) {
    set_colour(context, disc.black);
    cairo_arc(context, disc.centre_mm.x(), disc.centre_mm.y(), disc.radius_mm, 0, 2 * std::numbers::pi);
    cairo_fill(context);
  }
  set_colour(context, true);
  for (const auto& text : pattern.texts) draw_text(context, text);
}

/// Draws the sheet on a page whose unit is `units_per_mm` of a millimetre, and ends the page.
void draw_page(cairo_surface_t* page, const Pattern& pattern, double units_per_mm) {
  const double fine = kFiner * units_per_mm;
  const cairo_rectangle_t extents{0, 0, pattern.width_mm * fine, pattern.height_mm * fine};
  const Surface sheet(cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, &extents), cairo_surface_destroy);
  const Context pen(cairo_create(sheet.get()), cairo_destroy);
  cairo_scale(pen.get(), fine, fine);
  draw(pen.get(), pattern);
  check(cairo_status(pen.get()));

  const Context whole(cairo_create(page), cairo_destroy);
  cairo_scale(whole.get(), 1 / kFiner, 1 / kFiner);
  cairo_set_source_surface(whole.get(), sheet.get(), 0, 0);
  cairo_paint(whole.get());
  check(cairo_status(whole.get()));
  cairo_surface_finish(page);
  check(cairo_surface_status(page));
}

cairo_status_t append(void* text, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(text)->append(data, data + length);
  return CAIRO_STATUS_SUCCESS;
}

/// What stands between two texts, the first of which is searched from the end.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t start = text.rfind(before);
  const std::size_t end = start == std::string::npos ? start : text.find(after, start + before.size());
  if (end == std::string::npos) throw std::runtime_error("the PDF is not as cairo writes it: no '" + before + "'");
  return text.substr(start + before.size(), end - start - before.size());
}

/// Asks the viewer not to scale the page, which cairo cannot: an incremental update (ISO 32000-1, 7.5.6) replaces the
/// document's catalogue.
std::string without_scaling(const std::string& pdf) {
  const std::string trailer = between(pdf, "trailer\n<<", ">>");
  const std::string table = between(pdf, "startxref\n", "\n");
  const std::string root = between(trailer, "/Root ", " 0 R");
  const std::string catalogue = between(pdf, "\n" + root + " 0 obj\n<<", ">>\nendobj");
  std::string updated = pdf;
  const std::size_t object_at = updated.size();
  updated +=
      fmt::format("{} 0 obj\n<<{}   /ViewerPreferences << /PrintScaling /None >>\n>>\nendobj\n", root, catalogue);
  const std::size_t table_at = updated.size();
  updated += fmt::format("xref\n{} 1\n{:010} 00000 n \ntrailer\n<<{}   /Prev {}\n>>\nstartxref\n{}\n%%EOF\n", root,
                         object_at, trailer, table, table_at);
  return updated;
}

}  // namespace

std::string pattern_svg(const Pattern& pattern) {
  std::string svg;
  const Surface page(cairo_svg_surface_create_for_stream(append, &svg, pattern.width_mm, pattern.height_mm),
                     cairo_surface_destroy);
  cairo_svg_surface_set_document_unit(page.get(), CAIRO_SVG_UNIT_MM);
  draw_page(page.get(), pattern, 1);
  return svg;
}

std::string pattern_pdf(const Pattern& pattern) {
  std::string pdf;
  const Surface page(cairo_pdf_surface_create_for_stream(append, &pdf, pattern.width_mm * kPointsPerMm,
                                                         pattern.height_mm * kPointsPerMm),
                     cairo_surface_destroy);
  cairo_pdf_surface_restrict_to_version(page.get(), CAIRO_PDF_VERSION_1_4);
  cairo_pdf_surface_set_metadata(page.get(), CAIRO_PDF_METADATA_TITLE, pattern.title.c_str());
  cairo_pdf_surface_set_metadata(page.get(), CAIRO_PDF_METADATA_CREATOR, "horopter pattern");
  cairo_pdf_surface_set_metadata(page.get(), CAIRO_PDF_METADATA_CREATE_DATE, kCreationDate);
  draw_page(page.get(), pattern, kPointsPerMm);
  return without_scaling(pdf);
}

}  // namespace horopter::calib
