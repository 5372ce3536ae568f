// A folder of its own for each test, and a small scene in it: a wavy sheet of 8 x 8 quads with a 64 x 64 map.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "brushes/brush.h"
#include "editor/session/session.h"

namespace relievo::test {

class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

void write_text(const std::filesystem::path& path, const std::string& text);
std::string read_text(const std::filesystem::path& path);

// Writes sheet.obj, map.tif (unless `new_map`: the scene then names none) and scene.json. Returns the scene's
// path.
std::filesystem::path write_scene(const std::filesystem::path& folder, bool new_map = false);

// Runs `work` in another process that ends behind it; returns waitpid's status. To read or write images starts
// threads, which a fork leaves out with whatever locks they hold: who forks does so in children alone, before.
int run_forked(const std::function<void()>& work);

SessionOptions headless();

// A copy of the map's, row-major.
std::vector<std::uint16_t> texels(const Session& session);

// One stroke of `count` dabs along the sheet; `row` from 0 to 7 moves it across.
void sculpt(Session& session, int row, int count = 6, Tool tool = Tool::draw);

}  // namespace relievo::test
