// Options that verbs share: how they are declared, checked and turned into a session's options.
#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "editor/cli/verbs.h"
#include "renderer/methods/registry.h"

namespace relievo {
namespace {

constexpr int kMaxPixels = 16384;     // a side
constexpr int kMaxSamples = 1 << 20;  // a pixel

template <typename Number>
bool parse_whole(std::string_view text, Number& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() && !text.empty();
}

std::pair<std::string, double> parse_parameter(const std::string& text) {
    const auto equals = text.find('=');
    const std::string word = equals == std::string::npos ? "" : text.substr(equals + 1);
    double value = 0;
    if (const auto named = named_value(text.substr(0, equals), word)) {
        value = *named;
    } else if (word == "true" || word == "on") {
        value = 1;
    } else if (word != "false" && word != "off" && (!parse_whole(word, value) || !std::isfinite(value))) {
        throw std::invalid_argument("--set: is \"" + text + "\", must be PARAM=NUMBER, like dt=0.002");
    }
    return {text.substr(0, equals), value};
}

std::string method_help() {
    std::string text = "Method of tracing:";
    for (const Method* method : methods()) text.append(" ").append(method->name);
    return text + "; the scene's when not given";
}

std::string parameter_help() {
    std::string text = "Parameter of the method, repeatable:";
    for (const Method* method : methods())
        for (const MethodParameter& parameter : method->parameters)
            text.append(" ").append(method->name).append(".").append(parameter.name);
    return text + " (name without the method)";
}

}  // namespace

ImageSize parse_size(const std::string& text) {
    ImageSize size;
    const auto x = text.find('x');
    const bool whole = x != std::string::npos &&
                       parse_whole(std::string_view(text).substr(0, x), size.width) &&
                       parse_whole(std::string_view(text).substr(x + 1), size.height);
    if (!whole || size.width < 1 || size.height < 1 || size.width > kMaxPixels || size.height > kMaxPixels)
        throw std::invalid_argument("--size: is \"" + text +
                                    "\", must be WxH with both from 1 to 16384, like 640x480");
    return size;
}

void add_common(CLI::App& verb, CommonOptions& options) {
    verb.add_option("--device", options.device,
                    "Vulkan device: its index or a part of its name; RELIEVO_DEVICE says the same")
        ->type_name("DEVICE");
    verb.add_flag("--json", options.json, "Print the result as JSON");
}

void add_method(CLI::App& verb, MethodOptions& options) {
    verb.add_option("--method", options.method, method_help())->type_name("M");
    verb.add_option("--set", options.set, parameter_help())
        ->type_name("PARAM=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    verb.add_option("--path", options.path,
                    "Way of tracing: " + std::string(kTracePathNames) + "; the device's best when not given")
        ->type_name("PATH");
}

void add_picture(CLI::App& verb, PictureOptions& options) {
    verb.add_option("--spp", options.spp, "Samples a pixel, from 1; the scene's when not given")
        ->type_name("N")
        ->check(CLI::Range(1, kMaxSamples));
    verb.add_option("--size", options.size, "Picture size; the scene's when not given")->type_name("WxH");
}

SessionOptions session_options(const CommonOptions& common, const MethodOptions& method,
                               const PictureOptions& picture) {
    SessionOptions options;
    options.device = common.device;
    options.method = method.method;
    if (!method.method.empty()) find_method(method.method);
    for (const std::string& text : method.set)
        options.parameters.insert_or_assign(parse_parameter(text).first, parse_parameter(text).second);
    options.path = parse_trace_path(method.path);
    if (!picture.size.empty()) {
        const ImageSize size = parse_size(picture.size);
        options.width = size.width;
        options.height = size.height;
    }
    return options;
}

ImageSize size_of(const PictureOptions& picture, const Scene& scene) {
    if (picture.size.empty()) return {scene.image.width, scene.image.height};
    return parse_size(picture.size);
}

int samples_of(const PictureOptions& picture, const Scene& scene) {
    return picture.spp > 0 ? picture.spp : scene.image.spp;
}

}  // namespace relievo
