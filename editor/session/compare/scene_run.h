// The comparison over one scene: reference, errors of every point, times of all in rounds.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "editor/session/compare/budget.h"
#include "editor/session/compare/points.h"
#include "editor/session/compare/result.h"
#include "renderer/renderer.h"

namespace relievo {

struct SceneTask {
    std::filesystem::path file;
    std::string name;  // of the scene's pictures too
    std::vector<PointChoice> points;
    int width = 0, height = 0;  // 0: the scene's
    TracePath path = TracePath::automatic;
    std::filesystem::path folder;
};

// `part` of the scene's work that is done, [0, 1].
using TellPart = std::function<void(const std::string& what, double part)>;

ComparedScene compare_on_scene(vulkan::Context& context, const SceneTask& task, const Budget& budget,
                               const TellPart& tell);

}  // namespace relievo
