// Log-log plots as SVG: series of labelled points, their best front marked. No fonts or files of its own are
// needed.
#pragma once

#include <string>
#include <vector>

namespace relievo {

struct PlotPoint {
    double x = 0, y = 0;           // y of 0 is drawn at the axis' lower end
    double x_low = 0, x_high = 0;  // spread; equal to x: none
    std::string label, tip;        // beside the point, and when it is pointed at
    bool hollow = false;
    std::string line = {};  // neighbours are joined where it is the same
};
struct PlotSeries {
    std::string name;  // in the legend; empty: not there
    int color = 0;     // of plot_color
    std::vector<PlotPoint> points;
    bool faint = false;  // drawn thin, behind the others, without labels, and not of the front
};
struct Plot {
    std::string title, x_label, y_label;
    std::vector<std::string> notes;  // lines below, small
    std::vector<PlotSeries> series;
    double y_least = 1e-8;    // smaller errors are drawn there
    double y_guide = 0;       // a line across; 0: none
    bool x_is_ratio = false;  // ticks as "2x", a line at 1
};

std::string plot_color(int index);  // "#rrggbb": told apart by the colour-blind too
// `standalone`: as a file of its own; else for a page around it.
std::string plot_svg(const Plot& plot, bool standalone);
std::string escaped(const std::string& text);  // for XML and HTML

}  // namespace relievo
