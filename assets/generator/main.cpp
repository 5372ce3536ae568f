// relievo_assets: makes the sample meshes and maps, the same bytes on every machine.
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "assets/generator/options.h"
#include "assets/generator/samples.h"

int main(int argc, char** argv) {
    using namespace relievo::assets;
    try {
        const std::optional<Options> options = parse_options({argv + 1, argv + argc});
        if (!options) {
            std::cout << kUsage;
            return 0;
        }
        make_samples(*options, [](const std::string& line) { std::cerr << line << '\n'; });
        return 0;
    } catch (const std::invalid_argument& error) {
        std::cerr << "relievo_assets: " << error.what() << '\n';
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "relievo_assets: " << error.what() << '\n';
        return 1;
    }
}
