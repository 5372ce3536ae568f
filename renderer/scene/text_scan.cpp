// Reading text formats line by line: see the header.
#include "renderer/scene/text_scan.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace relievo {

std::string read_file(const std::filesystem::path& path) {
    const auto fail = [&](const char* what) -> std::string {
        throw std::invalid_argument(path.string() + ": " + what);
    };
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) return fail("no such file");
    if (std::filesystem::is_directory(status)) return fail("is a folder, must be a file");
    std::ifstream in(path, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (!in.is_open() || in.bad()) return fail("cannot be read");
    if (bytes.empty()) return fail("is empty");
    return bytes;
}

std::string_view next_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

std::string_view next_token(std::string_view& line) {
    constexpr std::string_view kBlanks = " \t\v\f\r";
    const std::size_t begin = line.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return line = {};
    line.remove_prefix(begin);
    const std::string_view token = line.substr(0, line.find_first_of(kBlanks));
    line.remove_prefix(token.size());
    return token;
}

namespace {

template <class Number>
std::optional<Number> parse_whole(std::string_view token) {
    if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (end != token.data() + token.size() || token.empty()) return std::nullopt;
    if (error == std::errc{}) return value;
    if constexpr (std::is_floating_point_v<Number>) {
        // Out of range: a subnormal or smaller is as good as 0, anything larger is infinite.
        if (error == std::errc::result_out_of_range) return std::strtod(std::string(token).c_str(), nullptr);
    }
    return std::nullopt;
}

}  // namespace

std::optional<double> parse_number(std::string_view token) {
    return parse_whole<double>(token);
}
std::optional<std::int64_t> parse_integer(std::string_view token) {
    return parse_whole<std::int64_t>(token);
}

std::string in_quotes(std::string_view token) {
    std::string text = "'";
    for (const char c : token.substr(0, 40)) text += static_cast<unsigned char>(c) < 32 ? '?' : c;
    return text + (token.size() > 40 ? "...'" : "'");
}

double require_number(std::string_view token, const std::string& where) {
    if (token.empty()) throw std::invalid_argument(where + ": a number is missing");
    const std::optional<double> value = parse_number(token);
    if (!value) throw std::invalid_argument(where + ": " + in_quotes(token) + " is not a number");
    if (!std::isfinite(*value)) {
        throw std::invalid_argument(where + ": " + in_quotes(token) +
                                    " is not finite; numbers must be finite");
    }
    return *value;
}

}  // namespace relievo
