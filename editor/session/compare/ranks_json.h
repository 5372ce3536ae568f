// Rank statistics as both reports' JSON has them.
#pragma once

#include <nlohmann/json.hpp>

#include "renderer/judge/image_comparison.h"

namespace relievo {

inline nlohmann::ordered_json ranks(const ErrorRanks& r) {
    return {{"median", r.median}, {"p99", r.p99}, {"p999", r.p999}, {"max", r.most}};
}

}  // namespace relievo
