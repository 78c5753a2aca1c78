// SPDX-License-Identifier: Apache-2.0
#include "tools/picture/Canvas.h"

#include <cairo/cairo.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string_view>

namespace kelpie::picture {
namespace {

constexpr double kHalfTurn = 3.14159265358979323846;
constexpr const char* kFamily = "DejaVu Sans";  // Debian: fonts-dejavu-core

struct FreeSurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct FreeDrawing {
  void operator()(cairo_t* drawing) const { cairo_destroy(drawing); }
};
struct FreeObject {
  void operator()(void* object) const { g_object_unref(object); }
};
struct FreeFont {
  void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }
};
using Layout = std::unique_ptr<PangoLayout, FreeObject>;

// Those that Pango names whatever there is.
bool isAlias(std::string_view family) {
  for (const std::string_view alias : {"Sans", "Serif", "Monospace", "System-ui"})
    if (family == alias) return true;
  return false;
}

// Where there are no fonts Pango draws boxes, or nothing, and tells nobody.
bool hasFonts() {
  PangoFontFamily** families = nullptr;
  int count = 0;
  pango_font_map_list_families(pango_cairo_font_map_get_default(), &families, &count);
  const bool found = std::any_of(families, families + count, [](PangoFontFamily* family) {
    return !isAlias(pango_font_family_get_name(family));
  });
  g_free(families);
  return found;
}

void setInk(cairo_t* drawing, const Ink& ink) {
  cairo_set_source_rgba(drawing, ink.red, ink.green, ink.blue, ink.cover);
}

void path(cairo_t* drawing, const std::vector<Spot>& spots) {
  cairo_new_path(drawing);
  for (const Spot& spot : spots) cairo_line_to(drawing, spot.x, spot.y);
}

void roundBox(cairo_t* drawing, const Frame& frame, double corner) {
  const double right = frame.x + frame.width, bottom = frame.y + frame.height;
  const double c = std::min({corner, frame.width / 2, frame.height / 2});
  cairo_new_path(drawing);
  if (c <= 0.0) return cairo_rectangle(drawing, frame.x, frame.y, frame.width, frame.height);
  cairo_arc(drawing, right - c, frame.y + c, c, -kHalfTurn / 2, 0);
  cairo_arc(drawing, right - c, bottom - c, c, 0, kHalfTurn / 2);
  cairo_arc(drawing, frame.x + c, bottom - c, c, kHalfTurn / 2, kHalfTurn);
  cairo_arc(drawing, frame.x + c, frame.y + c, c, kHalfTurn, 3 * kHalfTurn / 2);
  cairo_close_path(drawing);
}

PangoAlignment alignmentOf(Align align) {
  if (align == Align::centre) return PANGO_ALIGN_CENTER;
  return align == Align::right ? PANGO_ALIGN_RIGHT : PANGO_ALIGN_LEFT;
}

// A log may hold anything: what is no UTF-8 would be drawn as nothing.
std::string sound(const std::string& words) {
  char* valid = g_utf8_make_valid(words.c_str(), static_cast<gssize>(words.size()));
  std::string text = valid;
  g_free(valid);
  return text;
}

Layout layoutOf(cairo_t* drawing, const std::string& words, const Type& type, double width) {
  Layout layout(pango_cairo_create_layout(drawing));
  const std::unique_ptr<PangoFontDescription, FreeFont> font(pango_font_description_new());
  pango_font_description_set_family(font.get(), kFamily);
  pango_font_description_set_absolute_size(font.get(), type.size * PANGO_SCALE);
  if (type.bold) pango_font_description_set_weight(font.get(), PANGO_WEIGHT_BOLD);
  pango_layout_set_font_description(layout.get(), font.get());
  pango_layout_set_alignment(layout.get(), alignmentOf(type.align));
  pango_layout_set_text(layout.get(), sound(words).c_str(), -1);
  if (width <= 0.0) return layout;
  pango_layout_set_width(layout.get(), static_cast<int>(width * PANGO_SCALE));
  pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
  pango_layout_set_ellipsize(layout.get(), PANGO_ELLIPSIZE_END);
  pango_layout_set_height(layout.get(), -type.lines);
  return layout;
}

cv::Size2d sizeOf(PangoLayout* layout) {
  int width = 0, height = 0;
  pango_layout_get_pixel_size(layout, &width, &height);
  return {static_cast<double>(width), static_cast<double>(height)};
}

double leftOf(Spot where, const Type& type, double width) {
  if (type.align == Align::centre) return where.x - 0.5 * width;
  return type.align == Align::right ? where.x - width : where.x;
}

}  // namespace

struct Canvas::Surface {
  cv::Mat pixels;  // blue, green, red and a byte that Cairo does not use
  std::unique_ptr<cairo_surface_t, FreeSurface> surface;
  std::unique_ptr<cairo_t, FreeDrawing> drawing;

  Layout place(Spot where, const std::string& words, const Type& type, double width) const {
    Layout layout = layoutOf(drawing.get(), words, type, width);
    const double taken = width > 0.0 ? width : sizeOf(layout.get()).width;
    cairo_move_to(drawing.get(), leftOf(where, type, taken), where.y);
    return layout;
  }
  Status open() {
    surface.reset(cairo_image_surface_create_for_data(pixels.data, CAIRO_FORMAT_RGB24, pixels.cols,
                                                      pixels.rows,
                                                      static_cast<int>(pixels.step[0])));
    drawing.reset(cairo_create(surface.get()));
    if (cairo_status(drawing.get()) != CAIRO_STATUS_SUCCESS)
      return Error{std::string("the picture cannot be drawn: ") +
                   cairo_status_to_string(cairo_status(drawing.get()))};
    cairo_set_line_cap(drawing.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(drawing.get(), CAIRO_LINE_JOIN_ROUND);
    return Done{};
  }
};

Expected<Canvas> Canvas::over(const cv::Mat& picture) {
  if (!hasFonts()) return Error{"no font to write with (Debian: fonts-dejavu-core)"};
  auto surface = std::make_unique<Surface>();
  cv::cvtColor(picture, surface->pixels, cv::COLOR_BGR2BGRA);
  const Status opened = surface->open();
  if (!opened) return Error{opened.error()};
  return Canvas(std::move(surface));
}

Expected<Canvas> Canvas::create(cv::Size size, const Ink& ground) {
  return over(
      cv::Mat(size, CV_8UC3, cv::Scalar(255 * ground.blue, 255 * ground.green, 255 * ground.red)));
}

Canvas::Canvas(std::unique_ptr<Surface> surface) : surface_(std::move(surface)) {}
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;
Canvas::~Canvas() = default;

cv::Size Canvas::size() const { return surface_->pixels.size(); }

cv::Mat Canvas::picture() const {
  cairo_surface_flush(surface_->surface.get());
  cv::Mat result;
  cv::cvtColor(surface_->pixels, result, cv::COLOR_BGRA2BGR);
  return result;
}

void Canvas::box(const Frame& frame, const Ink& ink, double corner) {
  setInk(surface_->drawing.get(), ink);
  roundBox(surface_->drawing.get(), frame, corner);
  cairo_fill(surface_->drawing.get());
}

void Canvas::outline(const Frame& frame, const Ink& ink, double width, double corner) {
  setInk(surface_->drawing.get(), ink);
  roundBox(surface_->drawing.get(), frame, corner);
  cairo_set_line_width(surface_->drawing.get(), width);
  cairo_stroke(surface_->drawing.get());
}

void Canvas::disc(Spot middle, double radius, const Ink& ink) {
  setInk(surface_->drawing.get(), ink);
  cairo_new_path(surface_->drawing.get());
  cairo_arc(surface_->drawing.get(), middle.x, middle.y, radius, 0, 2 * kHalfTurn);
  cairo_fill(surface_->drawing.get());
}

void Canvas::ring(Spot middle, double radius, const Ink& ink, double width) {
  ellipse(middle, {radius, radius}, 0.0, ink, width);
}

void Canvas::ellipse(Spot middle, Spot radii, double turn, const Ink& ink, double width) {
  cairo_t* const drawing = surface_->drawing.get();
  setInk(drawing, ink);
  cairo_new_path(drawing);
  cairo_save(drawing);
  cairo_translate(drawing, middle.x, middle.y);
  cairo_rotate(drawing, turn);
  cairo_scale(drawing, std::max(radii.x, 0.1), std::max(radii.y, 0.1));
  cairo_arc(drawing, 0, 0, 1, 0, 2 * kHalfTurn);
  cairo_restore(drawing);
  cairo_set_line_width(drawing, width);
  cairo_stroke(drawing);
}

void Canvas::line(const std::vector<Spot>& spots, const Ink& ink, double width) {
  setInk(surface_->drawing.get(), ink);
  path(surface_->drawing.get(), spots);
  cairo_set_line_width(surface_->drawing.get(), width);
  cairo_stroke(surface_->drawing.get());
}

void Canvas::dashes(const std::vector<Spot>& spots, const Ink& ink, double width, double dash) {
  cairo_set_dash(surface_->drawing.get(), &dash, 1, 0);
  line(spots, ink, width);
  cairo_set_dash(surface_->drawing.get(), nullptr, 0, 0);
}

void Canvas::shape(const std::vector<Spot>& corners, const Ink& ink) {
  setInk(surface_->drawing.get(), ink);
  path(surface_->drawing.get(), corners);
  cairo_close_path(surface_->drawing.get());
  cairo_fill(surface_->drawing.get());
}

void Canvas::arrow(Spot from, Spot to, const Ink& ink, double width) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (length <= 0.0) return;
  const Spot ahead{(to.x - from.x) / length, (to.y - from.y) / length};
  const double head = std::min(4.0 * width, length);
  const Spot neck{to.x - head * ahead.x, to.y - head * ahead.y};
  const double half = 0.55 * head;
  line({from, neck}, ink, width);
  shape({to,
         {neck.x - half * ahead.y, neck.y + half * ahead.x},
         {neck.x + half * ahead.y, neck.y - half * ahead.x}},
        ink);
}

void Canvas::paste(const cv::Mat& picture, const Frame& frame, bool smooth) {
  cv::Mat pixels;
  cv::cvtColor(picture, pixels, cv::COLOR_BGR2BGRA);
  const std::unique_ptr<cairo_surface_t, FreeSurface> source(cairo_image_surface_create_for_data(
      pixels.data, CAIRO_FORMAT_RGB24, pixels.cols, pixels.rows, static_cast<int>(pixels.step[0])));
  cairo_t* const drawing = surface_->drawing.get();
  cairo_save(drawing);
  cairo_rectangle(drawing, frame.x, frame.y, frame.width, frame.height);
  cairo_clip(drawing);
  cairo_translate(drawing, frame.x, frame.y);
  cairo_scale(drawing, frame.width / pixels.cols, frame.height / pixels.rows);
  cairo_set_source_surface(drawing, source.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(drawing),
                           smooth ? CAIRO_FILTER_BILINEAR : CAIRO_FILTER_NEAREST);
  cairo_pattern_set_extend(cairo_get_source(drawing), CAIRO_EXTEND_PAD);
  cairo_paint(drawing);
  cairo_restore(drawing);
}

void Canvas::cut(const Frame& frame, double corner) {
  cairo_save(surface_->drawing.get());
  roundBox(surface_->drawing.get(), frame, corner);
  cairo_clip(surface_->drawing.get());
}

void Canvas::uncut() { cairo_restore(surface_->drawing.get()); }

cv::Size2d Canvas::text(Spot where, const std::string& words, const Type& type, double width) {
  const Layout layout = surface_->place(where, words, type, width);
  setInk(surface_->drawing.get(), type.ink);
  pango_cairo_show_layout(surface_->drawing.get(), layout.get());
  return sizeOf(layout.get());
}

cv::Size2d Canvas::label(Spot where, const std::string& words, const Type& type, double width) {
  const Layout layout = surface_->place(where, words, type, width);
  cairo_t* const drawing = surface_->drawing.get();
  setInk(drawing, {0.0, 0.0, 0.0, 0.75});
  cairo_set_line_width(drawing, 0.22 * type.size);
  pango_cairo_layout_path(drawing, layout.get());
  cairo_stroke(drawing);
  return text(where, words, type, width);
}

cv::Size2d Canvas::measure(const std::string& words, const Type& type, double width) const {
  return sizeOf(layoutOf(surface_->drawing.get(), words, type, width).get());
}

}  // namespace kelpie::picture
