// relievo devices: the Vulkan devices, which one is used, by which way of tracing, and why.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "editor/cli/verbs.h"
#include "renderer/vulkan/context.h"

namespace relievo {
namespace {

struct Choice {
    std::optional<std::uint32_t> index;
    std::string why_none;
};

// Asks as a session would, so that the answer is the truth about this machine and --device.
Choice choose(const std::string& device) {
    try {
        return {vulkan::Context({device, false, false}).info().index, ""};
    } catch (const std::runtime_error& error) {
        return {std::nullopt, error.what()};
    }
}

int run_devices(const CommonOptions& options) {
    const std::vector<vulkan::DeviceInfo> devices = vulkan::list_devices();
    const Choice choice = choose(options.device);
    if (options.json) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const vulkan::DeviceInfo& device : devices)
            list.push_back({{"index", device.index},
                            {"name", device.name},
                            {"driver", device.driver},
                            {"is_cpu", device.is_cpu},
                            {"ray_query", device.ray_query},
                            {"ray_pipeline", device.ray_pipeline},
                            {"usable", device.usable},
                            {"used", choice.index == device.index},
                            {"path", std::string(trace_path_name(device.best_path))},
                            {"verdict", device.verdict}});
        nlohmann::ordered_json result{{"devices", list}};
        if (!choice.index) result["none_usable"] = choice.why_none;
        std::cout << result.dump(2) << "\n";
        return 0;
    }
    for (const vulkan::DeviceInfo& device : devices)
        std::cout << (choice.index == device.index ? "* " : "  ") << device.index << "  " << device.name
                  << " (" << device.driver << "): " << device.verdict << "\n";
    std::cout << (choice.index ? "* is used; --device or RELIEVO_DEVICE choose another" : choice.why_none)
              << "\n";
    return 0;
}

}  // namespace

void add_devices(CLI::App& app, Command& command) {
    CLI::App& verb = *app.add_subcommand("devices", "List Vulkan devices, and say which is used and why");
    const auto options = std::make_shared<CommonOptions>();
    add_common(verb, *options);
    verb.callback([options, &command] { command = [options] { return run_devices(*options); }; });
}

}  // namespace relievo
