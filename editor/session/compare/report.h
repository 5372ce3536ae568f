// A comparison as files: results.csv, results.json, summary.md, index.html, and plots as SVG.
#pragma once

#include <filesystem>
#include <string>

#include "editor/session/compare/result.h"

namespace relievo {

std::string csv_text(const Comparison& comparison);       // one line a point
std::string json_text(const Comparison& comparison);      // everything but the rounds' single times
std::string markdown_text(const Comparison& comparison);  // the summary as tables
std::string html_text(const Comparison& comparison);      // needs nothing but the folder's pictures

// Writes them all, and plot_all.svg and a plot_NAME.svg a scene. Throws std::invalid_argument as
// write_file_atomically.
void write_report(const Comparison& comparison, const std::filesystem::path& folder);

}  // namespace relievo
