// load_mesh_file: from polygons as the file lists them to welded triangles.
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <unordered_map>

#include "renderer/scene/mesh_soup.h"
#include "renderer/scene/text_scan.h"

namespace relievo {

namespace {

constexpr const char* kNoUvHint =
    "no texture coordinates; displacement needs them (unwrap the mesh, or export OBJ or PLY with UVs)";

// Files write one normal a position with few digits; two that differ by less than this are one.
constexpr double kSameNormal = 1e-3;

template <class Vector>
struct BitHash {
    std::size_t operator()(const Vector& v) const {
        std::uint64_t hash = 1469598103934665603ull;
        for (int k = 0; k < Vector::length(); ++k) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(v[k])) * 1099511628211ull;
            hash ^= hash >> 32;
        }
        return static_cast<std::size_t>(hash);
    }
};

// Gives equal vectors one number, in the order in which they are first met.
template <class Vector>
class Welder {
  public:
    explicit Welder(std::vector<Vector>& out) : out_(out) {}
    std::uint32_t operator()(Vector v) {
        v += Vector(0);  // -0 becomes 0
        const auto [place, is_new] = numbers_.try_emplace(v, static_cast<std::uint32_t>(out_.size()));
        if (is_new) out_.push_back(v);
        return place->second;
    }

  private:
    std::vector<Vector>& out_;
    std::unordered_map<Vector, std::uint32_t, BitHash<Vector>> numbers_;
};

template <class Vector>
bool is_finite(const Vector& v) {
    for (int k = 0; k < Vector::length(); ++k) {
        if (!std::isfinite(v[k])) return false;
    }
    return true;
}

void check_corner(const std::string& file, const MeshSoup& soup, const MeshSoup::Corner& corner,
                  std::size_t face) {
    const auto fail = [&](const std::string& what) {
        throw std::invalid_argument(file + ": face " + std::to_string(face) + " (counted from 0): " + what);
    };
    if (corner.position < 0 || corner.position >= static_cast<std::int64_t>(soup.positions.size())) {
        fail("names vertex " + std::to_string(corner.position) + ", the file has " +
             std::to_string(soup.positions.size()) + " (counted from 0)");
    }
    if (!is_finite(soup.positions[static_cast<std::size_t>(corner.position)])) {
        fail("vertex " + std::to_string(corner.position) + " is NaN or infinite; positions must be finite");
    }
    if (corner.uv < 0) fail("has no texture coordinates; displacement needs them on every face");
    if (!is_finite(soup.uvs[static_cast<std::size_t>(corner.uv)])) {
        fail("texture coordinate " + std::to_string(corner.uv) + " is NaN or infinite; it must be finite");
    }
}

// The file's normals, when there is exactly one at every position; else the reason goes to the file.
class NormalCollector {
  public:
    void add(const MeshSoup& soup, const MeshSoup::Corner& corner, std::uint32_t position) {
        if (position >= normals_.size()) normals_.resize(position + 1, glm::dvec3(0));
        if (corner.normal < 0) {
            ++missing_;
            return;
        }
        const glm::dvec3 raw = soup.normals[static_cast<std::size_t>(corner.normal)];
        const double length = glm::length(raw);
        if (!(length > 0) || !std::isfinite(length)) {
            ++broken_;
            return;
        }
        glm::dvec3& known = normals_[position];
        if (known == glm::dvec3(0)) {
            known = raw / length;
        } else if (glm::length(known - raw / length) > kSameNormal) {
            ++several_;
        }
    }
    void finish(bool has_normals, MeshFile& file) {
        if (!has_normals) return;
        if (several_ > 0) {
            file.why_no_file_normals =
                "the file has several normals at one position; they are smoothed, or the "
                "displaced surface would tear";
        } else if (missing_ > 0) {
            file.why_no_file_normals = "some corners of the file have no normal; all are smoothed";
        } else if (broken_ > 0) {
            file.why_no_file_normals = "some normals of the file are zero, NaN or infinite; all are smoothed";
        } else {
            file.file_normals = std::move(normals_);
        }
    }

  private:
    std::vector<glm::dvec3> normals_;
    std::size_t several_ = 0, missing_ = 0, broken_ = 0;
};

std::string extension_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    return extension;
}

}  // namespace

MeshFile weld_soup(const std::filesystem::path& path, const MeshSoup& soup) {
    const std::string name = path.string();
    if (soup.face_ends.empty()) throw std::invalid_argument(name + ": has no faces");
    if (soup.uvs.empty()) {
        throw std::invalid_argument(name + ": " + (soup.no_uv_hint.empty() ? kNoUvHint : soup.no_uv_hint));
    }
    MeshFile file;
    file.path = path;
    file.warnings = soup.warnings;
    Welder<glm::dvec3> weld_position(file.positions);
    Welder<glm::dvec2> weld_uv(file.uvs);
    NormalCollector normals;
    std::vector<glm::dvec3> polygon;
    std::vector<std::uint32_t> positions, uvs;
    std::size_t begin = 0;
    for (std::size_t face = 0; face < soup.face_ends.size(); begin = soup.face_ends[face++]) {
        polygon.clear(), positions.clear(), uvs.clear();
        for (std::size_t c = begin; c < soup.face_ends[face]; ++c) {
            const MeshSoup::Corner& corner = soup.corners[c];
            check_corner(name, soup, corner, face);
            polygon.push_back(soup.positions[static_cast<std::size_t>(corner.position)]);
            positions.push_back(weld_position(polygon.back()));
            uvs.push_back(weld_uv(soup.uvs[static_cast<std::size_t>(corner.uv)]));
            normals.add(soup, corner, positions.back());
        }
        for (const auto& [a, b, c] : triangulate(polygon)) {
            file.faces.push_back({{positions[a], positions[b], positions[c]}, {uvs[a], uvs[b], uvs[c]}});
        }
    }
    if (file.faces.empty()) throw std::invalid_argument(name + ": has no face of 3 or more corners");
    normals.finish(!soup.normals.empty(), file);
    return file;
}

MeshFile load_mesh_file(const std::filesystem::path& path) {
    const std::string extension = extension_of(path);
    if (extension != ".obj" && extension != ".ply" && extension != ".off" && extension != ".stl") {
        throw std::invalid_argument(path.string() + ": unknown kind of mesh " + in_quotes(extension) +
                                    "; must be .obj, .ply, .stl or .off");
    }
    const std::string bytes = read_file(path);
    if (extension == ".obj") return weld_soup(path, read_obj(path, bytes));
    if (extension == ".ply") return weld_soup(path, read_ply(path, bytes));
    if (extension == ".off") return weld_soup(path, read_off(path, bytes));
    // The format has no place for texture coordinates, so there is nothing in it to read.
    throw std::invalid_argument(path.string() + ": " + kNoUvHint);
}

}  // namespace relievo
