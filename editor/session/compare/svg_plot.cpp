// See svg_plot.h.
#include "editor/session/compare/svg_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "editor/session/compare/answers.h"

namespace relievo {
namespace {

constexpr double kWidth = 660, kHeight = 442, kLeft = 74, kRight = 26, kLegend = 44, kBottom = 86;
constexpr double kMarker = 5;

template <typename... Values>
std::string text_of(const char* format, Values... values) {
    char text[512];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

// One axis: log10 of [low, high] onto [from, to] pixels.
struct Axis {
    double low, high, from, to;
    double at(double value) const {
        const double clamped = std::clamp(value, low, high);
        return from + (to - from) * std::log10(clamped / low) / std::log10(high / low);
    }
};

std::string power_of_ten(int exponent) {
    static const std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char letter : std::to_string(std::abs(exponent)))
        text += digits[static_cast<std::size_t>(letter - '0')];
    return text;
}

// 1, 2 and 5 times powers of ten where the axis is short, powers of ten where it is long.
std::vector<double> ticks_of(const Axis& axis) {
    const double decades = std::log10(axis.high / axis.low);
    std::vector<double> ticks;
    for (int e = static_cast<int>(std::floor(std::log10(axis.low))); e <= std::log10(axis.high); ++e)
        for (const double step : {1.0, 2.0, 5.0}) {
            const double value = step * std::pow(10.0, e);
            if (value < axis.low * 0.999 || value > axis.high * 1.001) continue;
            if (step == 1.0 || decades < 2.2) ticks.push_back(value);
        }
    return ticks;
}

struct Frame {
    Axis x, y;
};

Frame frame_of(const Plot& plot, double top) {
    double x_low = std::numeric_limits<double>::infinity(), x_high = 0, y_low = x_low, y_high = 0;
    for (const PlotSeries& series : plot.series)
        for (const PlotPoint& p : series.points) {
            x_low = std::min({x_low, p.x, p.x_low > 0 ? p.x_low : p.x});
            x_high = std::max({x_high, p.x, p.x_high});
            y_low = std::min(y_low, std::max(p.y, plot.y_least));
            y_high = std::max(y_high, p.y);
        }
    if (!(x_high > 0)) x_low = x_high = 1;
    if (!(y_high > 0)) y_low = y_high = 1e-3;
    const auto decade_below = [](double v) { return std::pow(10.0, std::floor(std::log10(v) + 1e-9)); };
    const auto decade_above = [](double v) { return std::pow(10.0, std::ceil(std::log10(v) - 1e-9)); };
    return {{x_low / 1.25, x_high * 1.35, kLeft, kWidth - kRight},
            {decade_below(y_low) / (decade_below(y_low) < y_low / 1.5 ? 1 : 1.8), decade_above(y_high) * 1.4,
             kHeight - kBottom, top}};
}

std::string axes(const Plot& plot, const Frame& f) {
    std::string svg;
    for (const double x : ticks_of(f.x)) {
        svg += text_of("<path d='M%.1f %.1fV%.1f' class='g'/>", f.x.at(x), f.y.from, f.y.to);
        svg += text_of("<text x='%.1f' y='%.1f' text-anchor='middle'>%g%s</text>", f.x.at(x), f.y.from + 18,
                       x, plot.x_is_ratio ? "×" : "");
    }
    for (const double y : ticks_of(f.y)) {
        const int exponent = static_cast<int>(std::lround(std::log10(y)));
        if (std::abs(std::log10(y) - exponent) > 0.01) continue;
        svg += text_of("<path d='M%.1f %.1fH%.1f' class='g'/>", f.x.from, f.y.at(y), f.x.to);
        svg += text_of("<text x='%.1f' y='%.1f' text-anchor='end'>%s</text>", f.x.from - 8, f.y.at(y) + 4,
                       power_of_ten(exponent).c_str());
    }
    if (plot.y_guide > f.y.low && plot.y_guide < f.y.high)
        svg += text_of("<path d='M%.1f %.1fH%.1f' class='guide'/>", f.x.from, f.y.at(plot.y_guide), f.x.to);
    if (plot.x_is_ratio && f.x.low < 1 && f.x.high > 1)
        svg += text_of("<path d='M%.1f %.1fV%.1f' class='guide'/>", f.x.at(1), f.y.from, f.y.to);
    svg += text_of("<path d='M%.1f %.1fH%.1fV%.1fH%.1fZ' class='box'/>", f.x.from, f.y.from, f.x.to, f.y.to,
                   f.x.from);
    svg += text_of("<text x='%.1f' y='%.1f' text-anchor='middle' class='l'>%s</text>",
                   (f.x.from + f.x.to) / 2, f.y.from + 38, escaped(plot.x_label).c_str());
    svg += text_of(
        "<text x='16' y='%.1f' text-anchor='middle' class='l' transform='rotate(-90 16 %.1f)'>%s</text>",
        (f.y.from + f.y.to) / 2, (f.y.from + f.y.to) / 2, escaped(plot.y_label).c_str());
    return svg;
}

std::string line_of(const PlotSeries& series, const Frame& f) {
    if (series.points.size() < 2) return "";
    std::string path = "<path fill='none' stroke='" + plot_color(series.color) +
                       text_of("' stroke-width='%s' stroke-opacity='%s' d='", series.faint ? "1.2" : "1.8",
                               series.faint ? "0.35" : "0.75");
    const PlotPoint* last = nullptr;
    for (const PlotPoint& p : series.points) {
        path += text_of("%s%.1f %.1f", last && last->line == p.line ? "L" : "M", f.x.at(p.x), f.y.at(p.y));
        last = &p;
    }
    return path + "'/>";
}

std::string marks_of(const PlotSeries& series, const Frame& f) {
    std::string svg;
    const std::string color = plot_color(series.color);
    for (const PlotPoint& p : series.points) {
        const double x = f.x.at(p.x), y = f.y.at(p.y);
        const std::string tip = "<title>" + escaped(p.tip) + "</title></circle>";
        if (series.faint) {
            svg += text_of("<circle cx='%.1f' cy='%.1f' r='2.2' fill='%s' fill-opacity='0.45'>", x, y,
                           color.c_str()) +
                   tip;
            continue;
        }
        if (p.x_high > p.x_low)
            svg += text_of("<path d='M%.1f %.1fH%.1f' stroke='%s' stroke-width='3' stroke-opacity='0.3'/>",
                           f.x.at(p.x_low), y, f.x.at(p.x_high), color.c_str());
        svg += text_of("<circle cx='%.1f' cy='%.1f' r='%.1f' fill='%s' stroke='%s' stroke-width='1.8'>", x, y,
                       kMarker, p.hollow ? "#fff" : color.c_str(), color.c_str()) +
               tip;
        svg += text_of("<text x='%.1f' y='%.1f' style='font-size:11px;fill:%s'>%s</text>", x + 8, y - 7,
                       color.c_str(), escaped(p.label).c_str());
    }
    return svg;
}

// Rings around the points that no other beats, and the steps between them.
std::string front_of(const Plot& plot, const Frame& f) {
    std::vector<FrontPoint> points;
    for (const PlotSeries& series : plot.series)
        if (!series.faint)
            for (const PlotPoint& p : series.points) points.push_back({p.x, std::max(p.y, plot.y_least)});
    std::string steps, rings;
    for (const std::size_t i : best_front(points)) {
        const double x = f.x.at(points[i].time), y = f.y.at(points[i].error);
        steps += steps.empty() ? text_of("M%.1f %.1fV%.1f", x, f.y.to, y) : text_of("H%.1fV%.1f", x, y);
        rings += text_of("<circle cx='%.1f' cy='%.1f' r='%.1f' class='ring'/>", x, y, kMarker + 4);
    }
    if (steps.empty()) return "";
    return "<path d='" + steps + text_of("H%.1f", f.x.to) + "' class='front'/>" + rings;
}

struct Legend {
    std::string svg;
    double y = kLegend;  // of its last row
};

Legend legend_of(const Plot& plot) {
    Legend legend;
    double x = kLeft;
    const auto entry = [&](const std::string& mark, const std::string& name) {
        const double width = 13 + 6.8 * static_cast<double>(name.size());
        if (x + width > kWidth && x > kLeft) {
            x = kLeft;
            legend.y += 17;
        }
        legend.svg += "<g transform='" + text_of("translate(%.1f %.1f)", x, legend.y) + "'>" + mark +
                      "<text x='13' y='4'>" + escaped(name) + "</text></g>";
        x += width + 17;
    };
    bool hollow = false;
    for (const PlotSeries& series : plot.series) {
        for (const PlotPoint& p : series.points) hollow = hollow || (p.hollow && !series.faint);
        if (series.name.empty()) continue;
        entry(text_of("<circle cx='3' r='%.1f' fill='%s'/>", kMarker, plot_color(series.color).c_str()),
              series.name);
    }
    entry(text_of("<circle cx='3' r='%.1f' class='ring'/>", kMarker + 2), "best front");
    if (hollow)
        entry(text_of("<circle cx='3' r='%.1f' fill='#fff' stroke='#555' stroke-width='1.8'/>", kMarker),
              "over 0.1% of hits missed or invented");
    return legend;
}

constexpr const char* kStyle =
    "<style>svg text{font:12px system-ui,Segoe UI,Helvetica,Arial,sans-serif;fill:#4a4f57}svg "
    ".t{font-size:15px;"
    "font-weight:600;fill:#1d2026}svg .l{font-size:12.5px;fill:#1d2026}svg .n{font-size:11px;fill:#7a808a}"
    "svg .g{stroke:#e6e8ec;fill:none}svg .box{stroke:#b9bec7;fill:none}"
    "svg .guide{stroke:#8a9099;stroke-dasharray:2 3;fill:none}"
    "svg .front{stroke:#1d2026;stroke-opacity:.45;stroke-dasharray:6 4;fill:none;stroke-width:1.3}"
    "svg .ring{stroke:#1d2026;fill:none;stroke-width:1.4}</style>";

}  // namespace

std::string plot_color(int index) {
    // Okabe and Ito's colours.
    static const std::array<const char*, 7> colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                   "#a06f00", "#3a8fb7", "#555555"};
    return colors[static_cast<std::size_t>(index) % colors.size()];
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char letter : text) {
        switch (letter) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\'':
                result += "&#39;";
                break;
            default:
                result += letter;
        }
    }
    return result;
}

std::string plot_svg(const Plot& plot, bool standalone) {
    const Legend legend = legend_of(plot);
    const Frame frame = frame_of(plot, legend.y + 18);
    std::string svg =
        text_of("<svg%s viewBox='0 0 %.0f %.0f' width='%.0f' height='%.0f' role='img'>",
                standalone ? " xmlns='http://www.w3.org/2000/svg'" : "", kWidth, kHeight, kWidth, kHeight);
    svg += kStyle;
    svg += text_of("<rect width='%.0f' height='%.0f' fill='#fff'/>", kWidth, kHeight);
    svg += text_of("<text x='%.1f' y='24' class='t'>%s</text>", kLeft, escaped(plot.title).c_str());
    svg += legend.svg + axes(plot, frame) + front_of(plot, frame);
    for (const bool faint : {true, false})
        for (const PlotSeries& series : plot.series)
            if (series.faint == faint) svg += line_of(series, frame) + marks_of(series, frame);
    double y = kHeight - kBottom + 60;
    for (const std::string& note : plot.notes) {
        svg += text_of("<text x='%.1f' y='%.1f' class='n'>%s</text>", kLeft, y, escaped(note).c_str());
        y += 15;
    }
    return svg + "</svg>\n";
}

}  // namespace relievo
