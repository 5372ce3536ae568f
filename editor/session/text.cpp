// Small wordings that messages share.
#include "editor/session/text.h"

#include <charconv>
#include <cstdarg>
#include <cstdio>

namespace relievo {

std::string number_text(double value) {
    char text[40];
    const auto single = static_cast<float>(value);  // 0.1f reads as 0.1, not as 0.10000000149
    const auto end = static_cast<double>(single) == value ? std::to_chars(text, text + sizeof text, single)
                                                          : std::to_chars(text, text + sizeof text, value);
    return {text, end.ptr};
}

std::string formatted(const char* format, ...) {
    char text[256];
    va_list values;
    va_start(values, format);
    std::vsnprintf(text, sizeof text, format, values);
    va_end(values);
    return text;
}

std::string range_text(double low, double high) {
    constexpr double kUnbounded = 1e18;
    if (high >= kUnbounded && low <= -kUnbounded) return "finite";
    if (high >= kUnbounded) return "at least " + number_text(low);
    return "in [" + number_text(low) + ", " + number_text(high) + "]";
}

std::string bytes_text(std::uint64_t bytes) {
    const double size = static_cast<double>(bytes);
    char text[40];
    if (size < 1e3)
        std::snprintf(text, sizeof text, "%.0f bytes", size);
    else if (size < 1e6)
        std::snprintf(text, sizeof text, "%.0f kB", size * 1e-3);
    else if (size < 1e9)
        std::snprintf(text, sizeof text, "%.1f MB", size * 1e-6);
    else
        std::snprintf(text, sizeof text, "%.1f GB", size * 1e-9);
    return text;
}

}  // namespace relievo
