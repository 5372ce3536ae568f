// See words.h.
#include "editor/session/compare/words.h"

#include <cmath>
#include <cstdio>

namespace relievo {
namespace {

std::string text_of(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace

std::string error_text(double error) {
    if (error == 0) return "0";
    if (std::abs(error) >= 0.01 && std::abs(error) < 1000) return text_of("%.2g", error);
    std::string text = text_of("%.1e", error);  // "3.4e-06": one zero too many
    const auto zero = text.find("e-0");
    if (zero != std::string::npos) text.erase(zero + 2, 1);
    return text;
}

std::string count_text(double count) {
    return text_of(count >= 100 ? "%.0f" : count >= 10 ? "%.1f" : "%.2f", count);
}

std::string ms_text(double ms) {
    const double size = std::abs(ms);
    return text_of(size >= 100 ? "%.0f" : size >= 10 ? "%.1f" : "%.2f", ms);
}

std::string ratio_text(double ratio) {
    return ratio > 0 ? text_of(ratio >= 10 ? "%.1f" : "%.2f", ratio) : "-";
}

std::string percent_text(double share) {
    if (share == 0) return "0";
    return text_of(share < 0.001 ? "%.3f%%" : "%.1f%%", 100 * share);
}

std::string spread_text(const Spread& spread) {
    return ms_text(spread.median) + " (" + ms_text(spread.p10) + " to " + ms_text(spread.p90) + ")";
}

std::string rival_text(const Rival& rival, const std::string& method) {
    if (rival.label.empty()) return "none does";
    std::string label = rival.label;
    if (label.starts_with(method + " ")) label.erase(0, method.size() + 1);
    if (rival.primary <= 0) return label + ": not timed";
    return label + ": " + ratio_text(rival.primary) + " (" + ratio_text(rival.preview) + ")";
}

}  // namespace relievo
