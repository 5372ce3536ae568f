// Wavefront OBJ: v, vt, vn and f; everything else is passed over. Read here rather than by OpenMesh, whose
// reader rounds positions to float, drops faces that name a vertex twice and knows no line numbers.
#include <stdexcept>

#include "renderer/scene/mesh_soup.h"
#include "renderer/scene/text_scan.h"

namespace relievo {

namespace {

class ObjReader {
  public:
    explicit ObjReader(const std::filesystem::path& path) : path_(path) {}

    MeshSoup read(std::string_view bytes) {
        while (!bytes.empty()) {
            std::string_view line = next_line(bytes);
            ++line_;
            read_line(line);
        }
        check_indices();
        return std::move(soup_);
    }

  private:
    std::string here() const { return path_.string() + ": line " + std::to_string(line_); }
    [[noreturn]] void fail(const std::string& what) const {
        throw std::invalid_argument(here() + ": " + what);
    }

    void read_line(std::string_view line) {
        const std::string_view word = next_token(line);
        if (word == "v") {
            soup_.positions.push_back(vector3(line, "v"));
        } else if (word == "vn") {
            soup_.normals.push_back(vector3(line, "vn"));
        } else if (word == "vt") {
            const std::string where = here() + ": vt";
            const double u = require_number(next_token(line), where);
            const std::string_view second = next_token(line);  // a 1D coordinate is allowed
            soup_.uvs.emplace_back(u, second.empty() ? 0.0 : require_number(second, where));
        } else if (word == "f") {
            read_face(line);
        }
    }

    glm::dvec3 vector3(std::string_view line, const char* word) const {
        const std::string where = here() + ": " + word;
        const double x = require_number(next_token(line), where);
        const double y = require_number(next_token(line), where);
        return {x, y, require_number(next_token(line), where)};
    }

    void read_face(std::string_view line) {
        const std::size_t begin = soup_.corners.size();
        for (std::string_view token = next_token(line); !token.empty(); token = next_token(line)) {
            if (token[0] == '#') break;
            if (token == "\\") fail("a face goes on in the next line; put it in one line");
            soup_.corners.push_back(corner(token));
        }
        if (soup_.corners.size() - begin < 3) fail("a face needs at least 3 corners");
        soup_.face_ends.push_back(soup_.corners.size());
        face_lines_.push_back(line_);
    }

    // v, v/vt, v//vn or v/vt/vn, counted from 1, or from the end by negative numbers.
    MeshSoup::Corner corner(std::string_view token) const {
        const std::string_view whole = token;
        std::int64_t index[3] = {-1, -1, -1};
        const std::size_t counts[3] = {soup_.positions.size(), soup_.uvs.size(), soup_.normals.size()};
        for (int part = 0; part < 3; ++part) {
            const std::size_t slash = token.find('/');
            const std::string_view number = token.substr(0, slash);
            if (!number.empty() || part == 0) {
                const std::optional<std::int64_t> value = parse_integer(number);
                if (!value || *value == 0) {
                    fail("corner " + in_quotes(whole) + " must be v, v/vt, v//vn or v/vt/vn, counted from 1");
                }
                index[part] = *value > 0 ? *value - 1 : static_cast<std::int64_t>(counts[part]) + *value;
                if (index[part] < 0) fail("corner " + in_quotes(whole) + " counts back past the first entry");
            }
            if (slash == std::string_view::npos) return {index[0], index[1], index[2]};
            token.remove_prefix(slash + 1);
        }
        fail("corner " + in_quotes(whole) + " has more than three parts");
    }

    // Faces may stand before the vertices they name, so this waits for the end of the file.
    void check_indices() {
        std::size_t begin = 0;
        for (std::size_t face = 0; face < soup_.face_ends.size(); begin = soup_.face_ends[face++]) {
            line_ = face_lines_[face];
            for (std::size_t c = begin; c < soup_.face_ends[face]; ++c) {
                const MeshSoup::Corner& corner = soup_.corners[c];
                check_index(corner.position, soup_.positions.size(), "vertex");
                check_index(corner.uv, soup_.uvs.size(), "texture coordinate");
                check_index(corner.normal, soup_.normals.size(), "normal");
                if (corner.uv < 0 && !soup_.uvs.empty()) {
                    fail("the face has no texture coordinates; displacement needs them on every face");
                }
            }
        }
    }
    void check_index(std::int64_t index, std::size_t count, const char* what) const {
        if (index < static_cast<std::int64_t>(count)) return;
        fail(std::string("the face names ") + what + " " + std::to_string(index + 1) + ", the file has " +
             std::to_string(count));
    }

    const std::filesystem::path& path_;
    MeshSoup soup_;
    std::vector<std::size_t> face_lines_;
    std::size_t line_ = 0;
};

}  // namespace

MeshSoup read_obj(const std::filesystem::path& path, std::string_view bytes) {
    return ObjReader(path).read(bytes);
}

}  // namespace relievo
