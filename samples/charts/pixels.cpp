// Drawings as pixels, by Cairo. Hinting is off and metrics are unrounded, so that letters have the same positions at
// any size and on any machine that has the font.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>

#include <cairo.h>

#include "samples/charts/drawing.h"
#include "samples/charts/own_font.h"
#include "samples/charts/theme.h"
#include "samples/scenes/check.h"

namespace charts
{
namespace
{

struct Release {
    void operator()(cairo_t *p) const { cairo_destroy(p); }
    void operator()(cairo_surface_t *p) const { cairo_surface_destroy(p); }
    void operator()(cairo_font_options_t *p) const { cairo_font_options_destroy(p); }
};
template <class Thing>
using Own = std::unique_ptr<Thing, Release>;

constexpr double pi = 3.14159265358979323846;

class Painter
{
public:
    explicit Painter(cairo_t *cairo) : cairo_(cairo) {}

    void operator()(const Box &b)
    {
        outline(b);
        if (b.fill == Fill::solid) {
            ink(b.paint);
            cairo_fill_preserve(cairo_);
        } else {
            pattern(b);
            outline(b);
        }
        ink(b.rim);
        cairo_set_line_width(cairo_, 1);
        cairo_stroke(cairo_);
    }
    void operator()(const Line &l)
    {
        ink(l.paint);
        cairo_set_line_width(cairo_, l.width);
        cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
        const std::vector<double> dashes = dashes_of(l.dash, l.width);
        cairo_set_dash(cairo_, dashes.data(), static_cast<int>(dashes.size()), 0);
        cairo_new_path(cairo_);
        for (const Point &p : l.points) cairo_line_to(cairo_, p.x, p.y);
        cairo_stroke(cairo_);
        cairo_set_dash(cairo_, nullptr, 0, 0);
    }
    void operator()(const Dot &d)
    {
        ink(d.paint);
        cairo_new_path(cairo_);
        cairo_arc(cairo_, d.at.x, d.at.y, d.radius, 0, 2 * pi);
        cairo_fill(cairo_);
    }
    void operator()(const Label &l)
    {
        const Lettering how = lettering(l.face);
        cairo_save(cairo_);
        ink({how.ink, 0});
        cairo_select_font_face(cairo_, font_family, CAIRO_FONT_SLANT_NORMAL,
                               how.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(cairo_, how.size_px);
        cairo_text_extents_t extents = {};
        cairo_text_extents(cairo_, l.text.c_str(), &extents);
        cairo_translate(cairo_, l.at.x, l.at.y);
        if (l.turn == Turn::upwards) cairo_rotate(cairo_, -pi / 2);
        const double share = l.anchor == Anchor::start ? 0 : l.anchor == Anchor::middle ? 0.5 : 1;
        cairo_move_to(cairo_, -share * extents.x_advance, 0);
        cairo_show_text(cairo_, l.text.c_str());
        cairo_restore(cairo_);
    }

private:
    void ink(const Paint &paint)
    {
        const Colour c = colour_of(paint, light);
        cairo_set_source_rgb(cairo_, c.red / 255.0, c.green / 255.0, c.blue / 255.0);
    }
    void outline(const Box &b)
    {
        const double left = b.at.x, top = b.at.y, right = left + b.width, bottom = top + b.height, r = b.corner;
        cairo_new_path(cairo_);
        if (r <= 0) return cairo_rectangle(cairo_, left, top, b.width, b.height);
        cairo_arc(cairo_, right - r, top + r, r, -pi / 2, 0);
        cairo_arc(cairo_, right - r, bottom - r, r, 0, pi / 2);
        cairo_arc(cairo_, left + r, bottom - r, r, pi / 2, pi);
        cairo_arc(cairo_, left + r, top + r, r, pi, 3 * pi / 2);
        cairo_close_path(cairo_);
    }
    // Stripes and dots are aligned to the sheet, not to the box, as in SVG.
    void pattern(const Box &b)
    {
        constexpr double each = 5;
        cairo_save(cairo_);
        cairo_clip(cairo_);
        ink(b.paint);
        if (b.fill == Fill::hatched) {
            // x + y is constant along a stripe; each stripe is 2 wide.
            const double step = each * std::sqrt(2.0), bottom = b.at.y + b.height, to = b.at.x + b.width + bottom;
            cairo_set_line_width(cairo_, 2);
            for (double at = step * (std::floor((b.at.x + b.at.y) / step) + 0.2); at <= to + step; at += step) {
                cairo_move_to(cairo_, at - b.at.y + each, b.at.y - each);
                cairo_line_to(cairo_, at - bottom - each, bottom + each);
            }
            cairo_stroke(cairo_);
        } else {
            for (double y = each * std::floor(b.at.y / each); y < b.at.y + b.height; y += each)
                for (double x = each * std::floor(b.at.x / each); x < b.at.x + b.width; x += each) {
                    cairo_new_sub_path(cairo_);
                    cairo_arc(cairo_, x + each / 2, y + each / 2, 1.4, 0, 2 * pi);
                }
            cairo_fill(cairo_);
        }
        cairo_restore(cairo_);
    }

    cairo_t *cairo_;
};

Pixels read_back(cairo_surface_t *surface)
{
    cairo_surface_flush(surface);
    Pixels pixels = {cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
    const unsigned char *rows = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    pixels.rgb.reserve(3 * static_cast<size_t>(pixels.width) * static_cast<size_t>(pixels.height));
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x) {
            uint32_t value = 0;
            std::memcpy(&value, rows + static_cast<ptrdiff_t>(stride) * y + 4 * x, 4);
            for (const int shift : {16, 8, 0}) pixels.rgb.push_back(static_cast<unsigned char>(value >> shift));
        }
    return pixels;
}

}  // namespace

Pixels pixels_of(const Drawing &drawing, double scale)
{
    prefer_own_font();
    const Own<cairo_surface_t> surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(drawing.width_px * scale)),
                                   static_cast<int>(std::lround(drawing.height_px * scale))));
    const Own<cairo_t> cairo(cairo_create(surface.get()));
    const Own<cairo_font_options_t> options(cairo_font_options_create());
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(cairo.get(), options.get());
    cairo_set_source_rgb(cairo.get(), 1, 1, 1);
    cairo_paint(cairo.get());
    cairo_scale(cairo.get(), scale, scale);
    Painter painter(cairo.get());
    for (const Mark &mark : drawing.marks) std::visit(painter, mark);
    const cairo_status_t status = cairo_status(cairo.get());
    if (status != CAIRO_STATUS_SUCCESS)
        throw scenes::Failure("Cairo could not draw the chart: " + std::string(cairo_status_to_string(status)));
    return read_back(surface.get());
}

}  // namespace charts
