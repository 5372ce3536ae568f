// A folder of its own for each test, and a small scene in it.
#include "tests/session/test_scene.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace relievo::test {
namespace fs = std::filesystem;

namespace {

constexpr int kQuads = 8;  // a side

std::string sheet_obj() {
    std::ostringstream obj;
    for (int y = 0; y <= kQuads; ++y)
        for (int x = 0; x <= kQuads; ++x) {
            const double u = static_cast<double>(x) / kQuads, v = static_cast<double>(y) / kQuads;
            obj << "v " << u * 2 - 1 << " " << v * 2 - 1 << " " << 0.1 * std::sin(5 * u) << "\nvt " << u
                << " " << v << "\n";
        }
    for (int y = 0; y < kQuads; ++y)
        for (int x = 0; x < kQuads; ++x) {
            const int a = y * (kQuads + 1) + x + 1, b = a + 1, d = a + kQuads + 1, c = d + 1;
            obj << "f " << a << "/" << a << " " << b << "/" << b << " " << c << "/" << c << "\n"
                << "f " << a << "/" << a << " " << c << "/" << c << " " << d << "/" << d << "\n";
        }
    return obj.str();
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "relievo-test-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

void write_text(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

std::string read_text(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

fs::path write_scene(const fs::path& folder, bool new_map) {
    write_text(folder / "sheet.obj", sheet_obj());
    std::string map = "\"size\": 64";
    if (!new_map) {
        HeightMap texels(64, 64);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                texels.set(x, y, static_cast<std::uint16_t>(30000 + 61 * x + 17 * y));
        save_map(texels, folder / "map.tif", MapFormat::tiff16);
        map = "\"map\": \"map.tif\"";
    }
    write_text(folder / "scene.json",
               R"({"relievo": 1, "objects": [{"mesh": "sheet.obj", "displacement": {)" + map +
                   R"(, "amplitude": 0.2, "midlevel": 0.5}}],
 "image": {"width": 64, "height": 48, "spp": 2}})");
    return folder / "scene.json";
}

int run_forked(const std::function<void()>& work) {
    const pid_t child = fork();
    if (child == 0) {
        work();
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

SessionOptions headless() {
    SessionOptions options;
    options.with_renderer = false;
    return options;
}

void sculpt(Session& session, int row, int count, Tool tool) {
    session.brush().tool = tool;
    session.brush().radius = 0.3f;
    session.begin_stroke();
    for (int i = 0; i < count; ++i) {
        Dab dab;
        dab.time_us = static_cast<std::uint32_t>(i) * 8000;
        dab.face = static_cast<std::uint32_t>(2 * (row * kQuads + i % kQuads));
        dab.b1 = 300000 + static_cast<std::uint32_t>(i) * 1000;
        dab.b2 = 200000;
        dab.pressure = 65535 - static_cast<std::uint32_t>(i) * 500;
        session.dab(dab);
    }
    session.end_stroke();
}

std::vector<std::uint16_t> texels(const Session& session) {
    const auto span = session.map().texels();
    return {span.begin(), span.end()};
}

}  // namespace relievo::test
