// PLY and OFF through OpenMesh's readers, into an importer that builds no topology (OpenMesh's own refuses
// non-manifold edges). What the readers leave unchecked is checked here: OpenMesh 9 reads a cut-off PLY as
// repeated faces, and a comment in an OFF as garbage. Both readers give positions in single precision.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/IO/reader/OFFReader.hh>
#include <OpenMesh/Core/IO/reader/PLYReader.hh>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include "renderer/scene/mesh_soup.h"
#include "renderer/scene/ply_header.h"
#include "renderer/scene/text_scan.h"

namespace relievo {

namespace {

namespace om = OpenMesh;

glm::dvec3 to_dvec3(const om::Vec3d& v) {
    return {v[0], v[1], v[2]};
}

// Collects vertices with their attributes, and polygons of vertex indices.
class SoupImporter final : public om::IO::BaseImporter {
  public:
    MeshSoup soup;
    bool has_uvs = false, has_normals = false;

    om::VertexHandle add_vertex(const om::Vec3f& p) override { return add_vertex(om::Vec3d(p)); }
    om::VertexHandle add_vertex(const om::Vec3d& p) override {
        soup.positions.push_back(to_dvec3(p));
        soup.uvs.emplace_back(0);
        soup.normals.emplace_back(0);
        return om::VertexHandle(static_cast<int>(soup.positions.size()) - 1);
    }
    om::VertexHandle add_vertex() override { return add_vertex(om::Vec3d(0)); }
    void set_point(om::VertexHandle v, const om::Vec3f& p) override {
        soup.positions[at(v)] = to_dvec3(om::Vec3d(p));
    }
    void set_normal(om::VertexHandle v, const om::Vec3f& n) override { set_normal(v, om::Vec3d(n)); }
    void set_normal(om::VertexHandle v, const om::Vec3d& n) override {
        soup.normals[at(v)] = to_dvec3(n);
        has_normals = true;
    }
    void set_texcoord(om::VertexHandle v, const om::Vec2f& t) override {
        soup.uvs[at(v)] = {t[0], t[1]};
        has_uvs = true;
    }
    void set_texcoord(om::VertexHandle v, const om::Vec3f& t) override {
        set_texcoord(v, om::Vec2f(t[0], t[1]));
    }

    om::FaceHandle add_face(const VHandles& vertices) override {
        for (const om::VertexHandle v : vertices) soup.corners.push_back({v.idx()});
        soup.face_ends.push_back(soup.corners.size());
        return om::FaceHandle(static_cast<int>(soup.face_ends.size()) - 1);
    }
    std::size_t n_vertices() const override { return soup.positions.size(); }
    std::size_t n_faces() const override { return soup.face_ends.size(); }
    std::size_t n_edges() const override { return 0; }

    // What a file may hold beside that is of no use here.
    om::HalfedgeHandle add_edge(om::VertexHandle, om::VertexHandle) override { return om::HalfedgeHandle(); }
    om::FaceHandle add_face(om::HalfedgeHandle) override { return om::FaceHandle(); }
    void add_face_texcoords(om::FaceHandle, om::VertexHandle, const std::vector<om::Vec2f>&) override {}
    void add_face_texcoords(om::FaceHandle, om::VertexHandle, const std::vector<om::Vec3f>&) override {}
    void set_face_texindex(om::FaceHandle, int) override {}
    void set_halfedge(om::VertexHandle, om::HalfedgeHandle) override {}
    void set_color(om::VertexHandle, const om::Vec3uc&) override {}
    void set_color(om::VertexHandle, const om::Vec4uc&) override {}
    void set_color(om::VertexHandle, const om::Vec3f&) override {}
    void set_color(om::VertexHandle, const om::Vec4f&) override {}
    void set_status(om::VertexHandle, const om::Attributes::StatusInfo&) override {}
    void set_next(om::HalfedgeHandle, om::HalfedgeHandle) override {}
    void set_face(om::HalfedgeHandle, om::FaceHandle) override {}
    void request_face_texcoords2D() override {}
    void set_texcoord(om::HalfedgeHandle, const om::Vec2f&) override {}
    void set_texcoord(om::HalfedgeHandle, const om::Vec3f&) override {}
    void set_status(om::HalfedgeHandle, const om::Attributes::StatusInfo&) override {}
    void set_color(om::EdgeHandle, const om::Vec3uc&) override {}
    void set_color(om::EdgeHandle, const om::Vec4uc&) override {}
    void set_color(om::EdgeHandle, const om::Vec3f&) override {}
    void set_color(om::EdgeHandle, const om::Vec4f&) override {}
    void set_status(om::EdgeHandle, const om::Attributes::StatusInfo&) override {}
    void set_normal(om::FaceHandle, const om::Vec3f&) override {}
    void set_normal(om::FaceHandle, const om::Vec3d&) override {}
    void set_color(om::FaceHandle, const om::Vec3uc&) override {}
    void set_color(om::FaceHandle, const om::Vec4uc&) override {}
    void set_color(om::FaceHandle, const om::Vec3f&) override {}
    void set_color(om::FaceHandle, const om::Vec4f&) override {}
    void set_status(om::FaceHandle, const om::Attributes::StatusInfo&) override {}
    void add_texture_information(int, std::string) override {}

    // The attributes of a vertex are those of each of its corners.
    MeshSoup take() {
        for (MeshSoup::Corner& corner : soup.corners) {
            corner.uv = has_uvs ? corner.position : -1;
            corner.normal = has_normals ? corner.position : -1;
        }
        if (!has_uvs) soup.uvs.clear();
        if (!has_normals) soup.normals.clear();
        return std::move(soup);
    }

  private:
    static std::size_t at(om::VertexHandle v) { return static_cast<std::size_t>(v.idx()); }
};

// OpenMesh's readers are single objects that keep state between calls, and talk on stderr.
class ReaderLock {
  public:
    ReaderLock() : lock_(mutex()), talks_(omerr().is_enabled()) { omerr().disable(); }
    ~ReaderLock() {
        if (talks_) omerr().enable();
    }
    ReaderLock(const ReaderLock&) = delete;
    ReaderLock& operator=(const ReaderLock&) = delete;

  private:
    static std::mutex& mutex() {
        static std::mutex one;
        return one;
    }
    std::scoped_lock<std::mutex> lock_;
    bool talks_;
};

om::IO::Options wanted() {
    return om::IO::Options::VertexNormal | om::IO::Options::VertexTexCoord;
}

// Where the reader gave up.
[[noreturn]] void fail_at(const std::filesystem::path& path, const PlyHeader& header, std::istringstream& in,
                          const std::string& text) {
    in.exceptions(std::ios::goodbit);
    in.clear();
    const std::size_t at =
        std::min(static_cast<std::size_t>(std::max<std::streamoff>(in.tellg(), 0)), text.size());
    std::string message = path.string() + ": ";
    if (header.ascii) {
        const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
        message += "line " +
                   std::to_string(static_cast<std::size_t>(lines) - header.lines + header.original_lines) +
                   ": cut off, or not a finite number";
    } else {
        message += "byte " + std::to_string(at + header.original_bytes - header.text.size()) + ": cut off";
    }
    throw std::invalid_argument(message);
}

void warn_of_lost_digits(const PlyHeader& header, MeshSoup& soup) {
    if (!header.doubles || soup.positions.empty()) return;
    glm::dvec3 low = soup.positions[0], high = low;
    for (const glm::dvec3& p : soup.positions) {
        for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
    double farthest = 0, extent = 0;
    for (int k = 0; k < 3; ++k) {
        farthest = std::max({farthest, std::abs(low[k]), std::abs(high[k])});
        extent = std::max(extent, high[k] - low[k]);
    }
    if (farthest > 256 * extent) {
        soup.warnings.push_back(
            "positions of a PLY file are read in single precision and stand far from zero; keep the mesh "
            "near "
            "zero and place it by the scene's transform, or use OBJ");
    }
}

}  // namespace

MeshSoup read_ply(const std::filesystem::path& path, const std::string& bytes) {
    const PlyHeader header = read_ply_header(path, bytes);
    const std::string text = header.text + bytes.substr(header.original_bytes);
    std::istringstream in(text);
    in.exceptions(std::ios::failbit | std::ios::badbit);
    SoupImporter importer;
    om::IO::Options options = wanted();
    const ReaderLock lock;
    try {
        if (!om::IO::PLYReader().read(in, importer, options)) {
            throw std::invalid_argument(path.string() +
                                        ": is not a PLY file of vertices with x, y, z and faces");
        }
    } catch (const std::ios_base::failure&) {
        fail_at(path, header, in, text);
    }
    MeshSoup soup = importer.take();
    warn_of_lost_digits(header, soup);
    if (header.corner_uvs) {
        soup.no_uv_hint =
            "no texture coordinates on the vertices, and those on faces ('texcoord') are not read; "
            "export OBJ, or PLY with s and t on the vertices";
    }
    return soup;
}

namespace {

// An OFF text without comments and blank lines, each line checked to hold what OpenMesh will read from it.
class OffScan {
  public:
    OffScan(const std::filesystem::path& path, std::string_view bytes) : path_(path), rest_(bytes) {}

    std::string clean_text() {
        if (!advance()) fail("is not an OFF file (it must start with OFF or STOFF)");
        std::string_view words = line_;
        const std::string_view keyword = next_token(words);
        std::string_view kind = keyword;
        const bool uvs = cut(kind, "ST"), colors = cut(kind, "C"), normals = cut(kind, "N");
        if (kind != "OFF") fail("is not an OFF file (it must start with OFF or STOFF)");
        std::string_view after = words;
        if (const std::string_view next = next_token(after); !next.empty()) {
            if (!parse_number(next)) fail("only text OFF files are read, not " + in_quotes(next));
            line_ = words;
        } else if (!advance()) {
            fail("is cut off after its first line");
        }
        text_ = std::string(keyword) + "\n" + std::string(line_) + "\n";
        const std::size_t vertices = count("vertices"), faces = count("faces");
        for (std::size_t i = 0; i < vertices; ++i) vertex(3u + 3u * normals + 2u * uvs, colors);
        for (std::size_t i = 0; i < faces; ++i) face();
        return std::move(text_);
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw std::invalid_argument(here() + ": " + what);
    }
    std::string here() const { return path_.string() + ": line " + std::to_string(number_); }
    static bool cut(std::string_view& word, std::string_view prefix) {
        if (!word.starts_with(prefix)) return false;
        word.remove_prefix(prefix.size());
        return true;
    }
    // To the next line that is neither blank nor a comment.
    bool advance() {
        while (!rest_.empty()) {
            line_ = next_line(rest_);
            line_ = line_.substr(0, line_.find('#'));
            ++number_;
            std::string_view words = line_;
            if (!next_token(words).empty()) return true;
        }
        return false;
    }
    std::size_t count(const char* what) {
        const std::string_view token = next_token(line_);
        const std::optional<std::int64_t> value = parse_integer(token);
        if (!value || *value < 0) fail(std::string("the number of ") + what + " is missing");
        return static_cast<std::size_t>(*value);
    }
    void vertex(unsigned numbers, bool colors) {
        if (!advance()) fail("cut off: a vertex is missing");
        std::string_view words = line_;
        unsigned found = 0;
        for (std::string_view token = next_token(words); !token.empty(); token = next_token(words), ++found) {
            require_number(token, here());
        }
        if (found < numbers || (!colors && found != numbers)) {
            fail("the vertex has " + std::to_string(found) + " numbers, must have " +
                 std::to_string(numbers));
        }
        text_ += std::string(line_) + "\n";
    }
    void face() {
        if (!advance()) fail("cut off: a face is missing");
        std::string_view words = line_;
        const std::optional<std::int64_t> corners = parse_integer(next_token(words));
        if (!corners || *corners < 3) fail("a face must start with its number of corners, at least 3");
        text_ += std::to_string(*corners);
        for (std::int64_t i = 0; i < *corners; ++i) {
            const std::optional<std::int64_t> index = parse_integer(next_token(words));
            if (!index || *index < 0 || *index > 0x7fffffff)
                fail("a corner of the face is missing or no index");
            text_ += ' ';
            text_ += std::to_string(*index);
        }
        text_ += "\n";  // colours are left out
    }

    const std::filesystem::path& path_;
    std::string_view rest_, line_;
    std::string text_;
    std::size_t number_ = 0;
};

}  // namespace

MeshSoup read_off(const std::filesystem::path& path, std::string_view bytes) {
    const std::string text = OffScan(path, bytes).clean_text();
    std::istringstream in(text);
    SoupImporter importer;
    om::IO::Options options = wanted();
    const ReaderLock lock;
    // The reader takes what a file holds from this call, not from the stream.
    if (!om::IO::OFFReader().can_u_read(path.string()) || !om::IO::OFFReader().read(in, importer, options)) {
        throw std::invalid_argument(path.string() + ": is not an OFF file that can be read");
    }
    return importer.take();
}

}  // namespace relievo
