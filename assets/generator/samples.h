// The table of sample assets, and writing them.
#pragma once

#include <functional>
#include <string>

#include "assets/generator/options.h"

namespace relievo::assets {

// Writes meshes and maps as `options` say; calls `progress` with a line for each asset. Throws
// std::invalid_argument for an unknown name, std::runtime_error that names the file when one cannot be
// written.
void make_samples(const Options& options, const std::function<void(const std::string&)>& progress);

}  // namespace relievo::assets
