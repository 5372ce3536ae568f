// The comparison as a page that opens without a network: tables and plots in it, pictures beside it.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "editor/session/compare/error_map.h"
#include "editor/session/compare/html_tables.h"
#include "editor/session/compare/page_style.h"
#include "editor/session/compare/plots.h"
#include "editor/session/compare/report.h"
#include "editor/session/compare/words.h"

namespace relievo {
namespace {

constexpr const char* kStyle = R"(<style>
.warn{background:#fff3d6;border-left:4px solid #e0a100;padding:8px 14px;margin:12px 0;max-width:none}
nav{margin:14px 0 4px;display:flex;flex-wrap:wrap;gap:6px}
nav a{padding:2px 12px;border-radius:99px;background:#fff;border:1px solid #d9dce2}
.plots{display:flex;flex-wrap:wrap;gap:14px}
.plots svg{flex:1 1 460px;max-width:660px;height:auto;border:1px solid #eceef2;border-radius:8px}
.scroll{overflow-x:auto}
thead tr:first-child th[colspan]{text-align:center;border-left:1px solid #e6e8ec;border-right:1px solid #e6e8ec}
td.point{text-align:left;font-weight:600}
td.point i{display:inline-block;width:10px;height:10px;border-radius:99px;margin-right:8px}
small{color:#7a808a}
.e0{background:#eaf6ee}.e1{background:#f7f8e4}.e2{background:#fdefdc}.e3{background:#fce3e0}
.pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(280px,1fr));gap:18px}
figure{margin:0;max-width:512px}
figure div{display:flex;flex-direction:column;gap:4px}
figure img{width:100%;height:auto;display:block;border-radius:6px;background:#26282e}
figcaption{font-size:13px;margin-top:4px}
details{margin:12px 0}
summary{cursor:pointer;color:#0057a8}
</style>
)";

std::string swatch(const Rgb& color) {
    char text[32];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", color[0], color[1], color[2]);
    return text;
}

// The colours of the error maps, one stop a decade.
std::string color_bar() {
    std::string stops, ticks;
    constexpr int kDecades = 6;
    for (int i = 0; i <= kDecades; ++i) {
        const double part = static_cast<double>(i) / kDecades;
        char text[160];
        std::snprintf(text, sizeof text, "<stop offset='%.4f' stop-color='%s'/>", part,
                      swatch(error_color(kErrorMapLow * std::pow(10.0, i))).c_str());
        stops += text;
        std::snprintf(text, sizeof text, "<text x='%.1f' y='34' text-anchor='middle'>%s</text>",
                      30 + 360 * part, error_text(kErrorMapLow * std::pow(10.0, i)).c_str());
        ticks += text;
    }
    const auto mark = [](double x, const Rgb& color, const char* name) {
        char text[200];
        std::snprintf(
            text, sizeof text,
            "<rect x='%.0f' y='4' width='16' height='14' rx='3' fill='%s'/><text x='%.0f' y='16'>%s</text>",
            x, swatch(color).c_str(), x + 22, name);
        return std::string(text);
    };
    return "<svg viewBox='0 0 660 40' width='660' height='40' role='img'><defs><linearGradient id='bar'>" +
           stops +
           "</linearGradient></defs><rect x='30' y='4' width='360' height='14' rx='3' fill='url(#bar)'/>" +
           ticks + mark(420, kMissedColor, "missed") + mark(500, kInventedColor, "invented") +
           mark(590, kNothingColor, "nothing") + "</svg>";
}

std::string pictures(const Comparison& comparison, const ComparedScene& scene) {
    std::string html = "<div class=pictures>";
    for (const ComparedPoint* point : by_method(comparison, scene)) {
        const ComparedPoint& p = *point;
        html += "<figure><div><img loading=lazy src='" + escaped(p.picture) + "' alt='" + escaped(p.label) +
                "'><img loading=lazy src='" + escaped(p.error_map) + "' alt='depth errors of " +
                escaped(p.label) + "'></div><figcaption><b>" + escaped(p.label) + "</b>" +
                (p.timed() ? ", " + ms_text(p.primary_ms()) + " ms" : "") + "; p99 " +
                error_text(p.errors.depth.p99) + ", " + std::to_string(p.wrong()) +
                " missed or invented</figcaption></figure>";
    }
    return html + "</div>";
}

std::string scene_facts(const ComparedScene& s) {
    std::string text = std::to_string(s.triangles) + " triangles";
    if (s.objects > 1) text += " in " + std::to_string(s.objects) + " objects";
    text += ", map " + std::to_string(s.map_width) + " × " + std::to_string(s.map_height) + ", frames of " +
            std::to_string(s.width) + " × " + std::to_string(s.height) + ", " + std::to_string(s.rounds) +
            " interleaved rounds; errors in units of the " + s.error_unit + ", " + error_text(s.unit_length) +
            "; reference traced in " + ms_text(s.reference_ms) + " ms";
    if (s.undecided > 0) text += ", " + std::to_string(s.undecided) + " pixels undecided";
    return escaped(text) + ".";
}

std::string notes(const std::vector<std::string>& sentences, const char* head) {
    if (sentences.empty()) return "";
    std::string html = std::string("<p class=warn><b>") + head + "</b> ";
    for (const std::string& sentence : sentences) html += escaped(sentence) + "; ";
    html.erase(html.size() - 2);
    return html + ".</p>\n";
}

std::string scene_section(const Comparison& c, const ComparedScene& s) {
    return "<section id='" + escaped(s.name) + "'><h2>" + escaped(s.name) + "</h2><p class=sub>" +
           scene_facts(s) + "</p>\n" + notes(s.cut, "Left out for the budget:") +
           notes(s.warnings, "The scene's warnings:") + "<div class=plots>" +
           plot_svg(scene_plot(c, s, PlottedError::p999), false) +
           plot_svg(scene_plot(c, s, PlottedError::p99), false) +
           plot_svg(scene_plot(c, s, PlottedError::gap), false) + "</div>\n<h3>Errors</h3>" +
           error_table(c, s) + "<h3>Costs</h3>" + cost_table(c, s) +
           "<details><summary>Errors by view angle</summary>" + angle_table(c, s) +
           "</details>\n<h3>Pictures, and the depth errors beside them</h3>" + color_bar() + pictures(c, s) +
           "</section>\n";
}

std::string setting(const Comparison& c) {
    char text[500];
    std::snprintf(text, sizeof text,
                  "%s, %d cores, %s. Device: %s, driver %s, traced by %s. Relievo %s. Measured in %.0f s",
                  c.machine.cpu.c_str(), c.machine.cores, c.machine.system.c_str(), c.device.c_str(),
                  c.driver.c_str(), c.path.c_str(), c.version.c_str(), c.spent_s);
    return escaped(text) + (c.budget_s > 0 ? " of a budget of " + ms_text(c.budget_s) + " s." : ".");
}

constexpr const char* kReading = R"(<details><summary>How to read this</summary>
<p>The judge is a double-precision reference that bounds and never samples. <b>Missed</b> and <b>invented</b> are pixels
where only the reference, or only the method, hits; those at silhouettes (within two pixels of a tear of the reference's
image) stand small. <b>Depth errors</b> are over the displacement's amplitude. <b>Unexplained</b> are pixels off by more
than 1% whose answer no ray of the reference within 0.002 pixels gives either (where many are wrong, estimated from
fifty). The <b>gap along edges</b> is how far apart the two triangles of an edge put the same point of it; a
<b>leak</b> is a ray straight at an edge that misses or hits elsewhere. <b>RMSE</b> (linear RGB) and <b>1 - SSIM</b>
(structural similarity of the displayed luma) compare the beauty with that of the scene's most exact point.</p>
<p>A frame of <b>primary rays</b> is one ray through each pixel's centre, with its normals; <b>with hard shadows</b> is
the picture that the window shows under a stroke. Times are medians of rounds in which every point is traced in turn,
after a warm-up round; <b>device</b> is the device's own clock. A ratio is the first method's time over the other's, the
median of the rounds' ratios, of primary frames and (in brackets) with hard shadows: below 1, the first is the quicker
one. The <b>best</b> setting is the coarsest whose p99.9 depth error is within 1% of the least.</p>
<p class=key>Errors: <span class=e0>to 10<sup>-4</sup></span><span class=e1>to 10<sup>-3</sup></span><span class=e2>to
10<sup>-2</sup></span><span class=e3>more</span></p></details>
)";

}  // namespace

std::string html_text(const Comparison& c) {
    std::string html =
        "<!doctype html><html lang=en><head><meta charset=utf-8><meta name=viewport "
        "content='width=device-width'><title>Relievo: error against run time</title>";
    html += std::string(kPageStyle) + kStyle;
    html += "</head><body><header><h1>Error against run time</h1><p class=sub>" + setting(c) + "</p>";
    if (c.machine.load > 0.5)
        html += "<p class=warn>The machine was busy when this began (load " + error_text(c.machine.load) +
                "): trust ratios more than times.</p>";
    html += "<nav>";
    for (const ComparedScene& s : c.scenes)
        html += "<a href='#" + escaped(s.name) + "'>" + escaped(s.name) + "</a>";
    html += "</nav></header><main><section><h2>All scenes</h2>";
    html += kReading;
    html += "<div class=plots>" + plot_svg(overall_plot(c, PlottedError::p999), false) +
            plot_svg(overall_plot(c, PlottedError::p99), false) + "</div><h3>Speed at equal error</h3>" +
            speed_table(c) + "<h3>Built at its best: bytes; ms to build; ms after an edit</h3>" +
            overview_table(built_table(c)) +
            "<h3>Every setting: frame of primary rays; p99.9; missed, invented</h3>" +
            overview_table(settings_table(c)) + "</section>\n";
    for (const ComparedScene& s : c.scenes) html += scene_section(c, s);
    return html +
           "</main><footer>All numbers: <a href='results.csv'>results.csv</a>, <a "
           "href='results.json'>results.json</a>, "
           "<a href='summary.md'>summary.md</a></footer></body></html>\n";
}

}  // namespace relievo
