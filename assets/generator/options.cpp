// Four options do not need a library.
#include "assets/generator/options.h"

#include <charconv>
#include <stdexcept>

namespace relievo::assets {
namespace {

int parse_size(const std::string& text) {
    int size = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
    if (error != std::errc() || end != text.data() + text.size() || size < 64 || size > 8192)
        throw std::invalid_argument("--size: '" + text + "' is not a whole number from 64 to 8192");
    return size;
}

}  // namespace

std::optional<Options> parse_options(const std::vector<std::string>& arguments) {
    Options options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& name = arguments[i];
        if (name == "--help" || name == "-h") return std::nullopt;
        const bool known = name == "-o" || name == "--size" || name == "--only" || name == "--scenes";
        if (!known) throw std::invalid_argument("unknown option '" + name + "'; --help lists them");
        if (i + 1 == arguments.size()) throw std::invalid_argument(name + ": a value is missing");
        const std::string& value = arguments[++i];
        if (name == "-o") options.output = value;
        if (name == "--size") options.size = parse_size(value);
        if (name == "--only") options.only = value;
        if (name == "--scenes") options.scenes = value;
    }
    if (options.output.empty()) throw std::invalid_argument("-o FOLDER is missing; --help shows the options");
    return options;
}

}  // namespace relievo::assets
