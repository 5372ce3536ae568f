// Readers of the sample assets' meshes and maps.
#include "tests/assets/obj_file.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

namespace relievo::assets_test {

ObjFile read_obj(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path.string() + ": cannot be read");
    ObjFile obj;
    std::string line;
    while (std::getline(file, line)) {
        if (line.starts_with('#')) continue;
        std::replace(line.begin(), line.end(), '/', ' ');
        std::istringstream words(line);
        std::string key;
        words >> key;
        glm::dvec3 v{0};
        if (key == "v" || key == "vn") {
            words >> v.x >> v.y >> v.z;
            (key == "v" ? obj.positions : obj.normals).push_back(v);
        } else if (key == "vt") {
            words >> v.x >> v.y;
            obj.uvs.push_back({v.x, v.y});
        } else if (key == "f") {
            std::array<Corner, 3> face{};
            for (Corner& c : face) {
                words >> c.position >> c.uv >> c.normal;
                --c.position, --c.uv, --c.normal;
                if (c.position >= obj.positions.size() || c.normal >= obj.normals.size())
                    throw std::runtime_error(path.string() + ": index out of range: " + line);
            }
            obj.faces.push_back(face);
        } else {
            throw std::runtime_error(path.string() + ": unexpected line: " + line);
        }
        std::string rest;
        if (words.fail() || words >> rest) throw std::runtime_error(path.string() + ": bad line: " + line);
    }
    return obj;
}

MapFile read_map(const std::filesystem::path& path) {
    const std::unique_ptr<OIIO::ImageInput> file = OIIO::ImageInput::open(path.string());
    if (!file) throw std::runtime_error(path.string() + ": cannot be read");
    const OIIO::ImageSpec& spec = file->spec();
    MapFile map{spec.width, static_cast<int>(spec.format.size() * 8), {}};
    if (spec.width != spec.height || spec.nchannels != 1 || (map.bits != 8 && map.bits != 16))
        throw std::runtime_error(path.string() + ": is not a square map of one channel");
    const auto side = static_cast<std::size_t>(map.side);
    map.counts.resize(side * side);
    if (!file->read_image(0, 0, 0, 1, OIIO::TypeDesc::UINT16, map.counts.data()))
        throw std::runtime_error(path.string() + ": is cut off");
    for (std::size_t y = 0; y < side / 2; ++y)
        std::swap_ranges(map.counts.begin() + static_cast<std::ptrdiff_t>(y * side),
                         map.counts.begin() + static_cast<std::ptrdiff_t>((y + 1) * side),
                         map.counts.begin() + static_cast<std::ptrdiff_t>((side - 1 - y) * side));
    return map;
}

double MapFile::bilinear(glm::dvec2 uv) const {
    const double x = uv.x * side - 0.5, y = uv.y * side - 0.5;
    const double fx = x - std::floor(x), fy = y - std::floor(y);
    const auto at = [&](double column, double row) {
        const int i = std::clamp(static_cast<int>(column), 0, side - 1);
        const int j = std::clamp(static_cast<int>(row), 0, side - 1);
        return static_cast<double>(counts[static_cast<std::size_t>(j) * static_cast<std::size_t>(side) +
                                          static_cast<std::size_t>(i)]);
    };
    const double x0 = std::floor(x), y0 = std::floor(y);
    return (at(x0, y0) * (1 - fx) + at(x0 + 1, y0) * fx) * (1 - fy) +
           (at(x0, y0 + 1) * (1 - fx) + at(x0 + 1, y0 + 1) * fx) * fy;
}

}  // namespace relievo::assets_test
