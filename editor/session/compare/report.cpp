// See report.h.
#include "editor/session/compare/report.h"

#include <span>

#include "brushes/atomic_file.h"
#include "editor/session/compare/plots.h"

namespace relievo {
namespace {

void write(const std::filesystem::path& path, const std::string& text) {
    write_file_atomically(path, std::as_bytes(std::span(text)));
}

}  // namespace

void write_report(const Comparison& comparison, const std::filesystem::path& folder) {
    for (const ComparedScene& scene : comparison.scenes)
        write(folder / ("plot_" + scene.name + ".svg"),
              plot_svg(scene_plot(comparison, scene, PlottedError::p999), true));
    write(folder / "plot_all.svg", plot_svg(overall_plot(comparison, PlottedError::p999), true));
    write(folder / "results.csv", csv_text(comparison));
    write(folder / "results.json", json_text(comparison));
    write(folder / "summary.md", markdown_text(comparison));
    write(folder / "index.html", html_text(comparison));
}

}  // namespace relievo
