// Mesh files: what is read, what survives, and one clear message for each bad input.
#include <cmath>
#include <cstring>
#include <limits>

#include "renderer/scene/mesh.h"
#include "renderer/scene/mesh_soup.h"
#include "tests/scene/test_files.h"

namespace relievo::mesh_file_test {
namespace {

class MeshFiles : public TestFiles {
  protected:
    MeshFile load(const std::string& name, const std::string& bytes) const {
        return load_mesh_file(write(name, bytes));
    }
    // The message without the folder.
    std::string refused(const std::string& name, const std::string& bytes) const {
        const std::filesystem::path path = write(name, bytes);
        std::string message = refusal([&] { load_mesh_file(path); });
        EXPECT_TRUE(message.starts_with(path.string() + ": ")) << message;
        return message.substr(std::min(message.size(), path.string().size() - name.size()));
    }
};

const std::string kPlyHeader =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "property float nx\nproperty float ny\nproperty float nz\nproperty float s\nproperty float t\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string kPlyVertices = "0 0 0 0 0 1 .25 .5\n1 0 0 0 0 1 1 0\n0 1 0 0 0 1 0 1\n";

std::string binary_ply(float first_x, int vertex_count, const std::string& endian = "binary_little_endian") {
    std::string bytes = kPlyHeader;
    bytes.replace(bytes.find("ascii"), 5, endian);
    for (int i = 0; i < vertex_count; ++i) {
        const float values[8] = {i == 0 ? first_x : 1.0f, i == 2 ? 1.0f : 0.0f, 0, 0, 0, 1, 0.25f, 0.5f};
        for (const float value : values) {
            char raw[4];
            std::memcpy(raw, &value, 4);
            if (endian == "binary_big_endian") std::reverse(raw, raw + 4);
            bytes.append(raw, 4);
        }
    }
    const std::string face = endian == "binary_big_endian" ? std::string("\3\0\0\0\0\0\0\0\1\0\0\0\2", 13)
                                                           : std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
    return bytes + face;
}

TEST_F(MeshFiles, obj_keeps_uvs_of_corners_and_cuts_quads) {
    const MeshFile file = load("quad.OBJ", kQuadObj);
    ASSERT_EQ(file.faces.size(), 2u);
    EXPECT_EQ(file.positions.size(), 4u);
    EXPECT_EQ(file.faces[0].position, (std::array<std::uint32_t, 3>{0, 1, 2}));
    EXPECT_EQ(file.faces[1].position, (std::array<std::uint32_t, 3>{0, 2, 3}));
    EXPECT_EQ(file.uvs[file.faces[1].uv[2]], glm::dvec2(0, 1));
}

TEST_F(MeshFiles, obj_positions_keep_double_digits_far_from_zero) {
    std::string text = kQuadObj;
    text.replace(0, 8, "v 100000.000001 0 0\n");
    EXPECT_DOUBLE_EQ(load("far.obj", text).positions[0].x, 100000.000001);
}

TEST_F(MeshFiles, obj_negative_indices_comments_crlf_and_a_seam) {
    const MeshFile file =
        load("a.obj",
             "# two faces, one seam\r\no thing\r\nv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nvt 0 0\r\nvt .5 0\r\n"
             "vt 0 .5\r\ns off\r\nf -3/-3 -2/-2 -1/-1 # first\r\nv 1 1 0\r\nvt 1 1\r\nf 2/4 4/1 3/3\r\n");
    ASSERT_EQ(file.faces.size(), 2u);
    EXPECT_EQ(file.faces[0].position[1], file.faces[1].position[0]);
    EXPECT_NE(file.faces[0].uv[1], file.faces[1].uv[0]);
}

TEST_F(MeshFiles, duplicate_vertices_are_welded_and_unused_ones_left_out) {
    const MeshFile file =
        load("d.obj",
             "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv -0.0 0 0\nv 1 0 0\nv 0 -1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
             "f 2/1 3/2 4/3\nf 5/1 7/2 6/3\n");
    EXPECT_EQ(file.positions.size(), 4u);
    EXPECT_EQ(file.faces[0].position[0], file.faces[1].position[0]);
    EXPECT_EQ(file.faces[0].position[1], file.faces[1].position[2]);
}

TEST_F(MeshFiles, non_manifold_edges_and_faces_without_area_survive_in_order) {
    const MeshFile file = load("n.obj",
                               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
                               "f 1/1 2/2 3/3\nf 1/1 2/2 4/3\nf 1/1 2/2 5/3\nf 1/1 1/2 2/3\nf 1/1 2/2 3/3\n");
    ASSERT_EQ(file.faces.size(), 5u);
    EXPECT_EQ(file.faces[3].position, (std::array<std::uint32_t, 3>{0, 0, 1}));
    const Mesh mesh = make_mesh(file, glm::dmat4(1), glm::dvec3(0), true);
    ASSERT_EQ(mesh.warnings.size(), 1u);
    EXPECT_EQ(mesh.warnings[0], "1 of 5 triangles have no area; they are kept but not rendered");
}

TEST_F(MeshFiles, concave_polygon_is_cut_inside) {
    const std::vector<glm::dvec3> arrow = {{0, 0, 0}, {2, -1, 0}, {1, 0, 0}, {2, 1, 0}};
    double area = 0;
    for (const auto& [a, b, c] : triangulate(arrow)) {
        const glm::dvec3 u = arrow[b] - arrow[a], v = arrow[c] - arrow[a];
        EXPECT_GT(u.x * v.y - u.y * v.x, 0);
        area += (u.x * v.y - u.y * v.x) / 2;
    }
    EXPECT_DOUBLE_EQ(area, 1);
    EXPECT_EQ(triangulate(std::vector<glm::dvec3>(7, glm::dvec3(0))).size(), 5u);
    EXPECT_EQ(triangulate(std::vector<glm::dvec3>(1000, glm::dvec3(0))).size(), 998u);
}

TEST_F(MeshFiles, one_normal_a_position_is_kept_and_several_are_not) {
    const std::string mesh =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nvn 0 3 4\nvn 0 0 1\n";
    const MeshFile one = load("1.obj", mesh + "f 1/1/1 2/2/1 3/3/1\nf 2/2/1 4/4/2 3/3/1\n");
    ASSERT_EQ(one.file_normals.size(), 4u);
    EXPECT_NEAR(one.file_normals[0].y, 0.6, 1e-15);
    const MeshFile several = load("2.obj", mesh + "f 1/1/1 2/2/1 3/3/1\nf 2/2/2 4/4/2 3/3/2\n");
    EXPECT_TRUE(several.file_normals.empty());
    EXPECT_NE(several.why_no_file_normals.find("several normals"), std::string::npos);
    EXPECT_EQ(make_mesh(several, glm::dmat4(1), glm::dvec3(0), true).warnings.size(), 1u);
    EXPECT_TRUE(make_mesh(several, glm::dmat4(1), glm::dvec3(0), false).warnings.empty());
    const MeshFile zero = load("3.obj", mesh + "vn 0 0 0\nf 1/1/3 2/2/1 3/3/1\n");
    EXPECT_TRUE(zero.file_normals.empty());
    EXPECT_FALSE(zero.why_no_file_normals.empty());
}

TEST_F(MeshFiles, ply_text_binary_and_every_name_of_texture_coordinates) {
    const std::string names[][2] = {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}};
    for (const auto& [u, v] : names) {
        std::string header = kPlyHeader;
        header.replace(header.find("vertex_indices"), 14, u == "u" ? "vertex_index" : "vertex_indices");
        header.replace(header.find("float s"), 7, "float " + u);
        header.replace(header.find("float t\n"), 8, "float " + v + "\n");
        const MeshFile file = load("a.ply", header + kPlyVertices + "3 0 1 2\n");
        ASSERT_EQ(file.faces.size(), 1u);
        EXPECT_EQ(file.uvs[file.faces[0].uv[0]], glm::dvec2(0.25, 0.5));
        EXPECT_EQ(file.file_normals.size(), 3u);
    }
    for (const std::string endian : {"binary_little_endian", "binary_big_endian"}) {
        const MeshFile file = load("b.ply", binary_ply(0.5f, 3, endian));
        ASSERT_EQ(file.faces.size(), 1u);
        EXPECT_EQ(file.positions[0], glm::dvec3(0.5, 0, 0));
    }
}

TEST_F(MeshFiles, off_with_texture_coordinates_comments_and_polygons) {
    const MeshFile file =
        load("a.off",
             "STOFF # a quad\n\n4 1 0\n# corners\n0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n"
             "4 0 1 2 3 255 0 0\n");
    ASSERT_EQ(file.faces.size(), 2u);
    EXPECT_EQ(file.uvs[file.faces[0].uv[2]], glm::dvec2(1, 1));
    EXPECT_EQ(load("b.off", "STOFF 3 1 0\n0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n3 0 1 2").faces.size(), 1u);
}

TEST_F(MeshFiles, no_texture_coordinates) {
    const std::string want =
        ": no texture coordinates; displacement needs them (unwrap the mesh, or export OBJ or PLY "
        "with UVs)";
    EXPECT_EQ(refused("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "a.obj" + want);
    EXPECT_EQ(refused("a.stl", "solid a\nendsolid a\n"), "a.stl" + want);
    EXPECT_EQ(refused("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "a.off" + want);
    std::string ply = kPlyHeader + "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n";
    ply.erase(ply.find("property float s"), 34);
    EXPECT_EQ(refused("a.ply", ply), "a.ply" + want);
    ply.replace(ply.find("end_header"), 10, "property list uchar float texcoord\nend_header");
    EXPECT_NE(refused("b.ply", ply + "6 0 0 1 0 0 1\n").find("texture coordinates"), std::string::npos);
    EXPECT_EQ(refused("b.obj", kQuadObj + "f 1 2 3\n"),
              "b.obj: line 10: the face has no texture coordinates; displacement needs them on every face");
}

TEST_F(MeshFiles, missing_empty_folder_and_unknown_kind) {
    const auto message = [&](const std::filesystem::path& path) {
        return refusal([&] { load_mesh_file(path); });
    };
    EXPECT_EQ(message("/nowhere/a.obj"), "/nowhere/a.obj: no such file");
    EXPECT_EQ(refused("e.obj", ""), "e.obj: is empty");
    std::filesystem::create_directory(folder() / "d.obj");
    EXPECT_NE(message(folder() / "d.obj").find("is a folder"), std::string::npos);
    EXPECT_EQ(refused("a.fbx", "x"), "a.fbx: unknown kind of mesh '.fbx'; must be .obj, .ply, .stl or .off");
    EXPECT_EQ(refused("a.obj", "v 0 0 0\nvt 0 0\n"), "a.obj: has no faces");
    EXPECT_EQ(refused("g.obj", std::string("\0\1\2\xff garbage", 12)), "g.obj: has no faces");
}

TEST_F(MeshFiles, obj_errors_name_the_line) {
    const std::pair<const char*, const char*> cases[] = {
        {"v nan 0 0\n", "a.obj: line 1: v: 'nan' is not finite; numbers must be finite"},
        {"v 0 0 0\nvt 0 -inf\n", "a.obj: line 2: vt: '-inf' is not finite; numbers must be finite"},
        {"v 0 1e999 0\n", "a.obj: line 1: v: '1e999' is not finite; numbers must be finite"},
        {"v 0 zero 0\n", "a.obj: line 1: v: 'zero' is not a number"},
        {"v 0 0\n", "a.obj: line 1: v: a number is missing"},
        {"f 1/1 2/2\n", "a.obj: line 1: a face needs at least 3 corners"},
        {"f 1/1 2/2 x\n", "a.obj: line 1: corner 'x' must be v, v/vt, v//vn or v/vt/vn, counted from 1"},
        {"f 1/1 2/2 0/1\n", "a.obj: line 1: corner '0/1' must be v, v/vt, v//vn or v/vt/vn, counted from 1"},
        {"f 1/1 2/2 -9/1\n", "a.obj: line 1: corner '-9/1' counts back past the first entry"},
        {"f 1/1/1/1 2/2 3/3\n", "a.obj: line 1: corner '1/1/1/1' has more than three parts"},
        {"f 1/1 2/2 99999999999999999999\n",
         "a.obj: line 1: corner '99999999999999999999' must be v, v/vt, v//vn or v/vt/vn, counted from 1"},
    };
    for (const auto& [text, message] : cases) EXPECT_EQ(refused("a.obj", text), message);
    EXPECT_EQ(refused("a.obj", kQuadObj + "f 1/1 2/2 5/3\n"),
              "a.obj: line 10: the face names vertex 5, the file has 4");
    EXPECT_EQ(refused("a.obj", kQuadObj + "f 1/1 2/2 3/9\n"),
              "a.obj: line 10: the face names texture coordinate 9, the file has 4");
    EXPECT_EQ(refused("a.obj", kQuadObj + "f 1/1 2/2 \\\n3/3\n"),
              "a.obj: line 10: a face goes on in the next line; put it in one line");
}

TEST_F(MeshFiles, ply_errors) {
    EXPECT_NE(refused("a.ply", "hello").find("is not a PLY file"), std::string::npos);
    EXPECT_NE(
        refused("a.ply", kPlyHeader.substr(0, kPlyHeader.find("element face"))).find("header is cut off"),
        std::string::npos);
    EXPECT_EQ(refused("a.ply", kPlyHeader + kPlyVertices + "3 0 1 9\n"),
              "a.ply: face 0 (counted from 0): names vertex 9, the file has 3 (counted from 0)");
    EXPECT_EQ(refused("a.ply", kPlyHeader + kPlyVertices + "3 0 -1 1\n"),
              "a.ply: face 0 (counted from 0): names vertex -1, the file has 3 (counted from 0)");
    EXPECT_EQ(refused("a.ply", kPlyHeader + kPlyVertices + "3 0\n"),
              "a.ply: line 19: cut off, or not a finite number");
    EXPECT_EQ(refused("a.ply", kPlyHeader + "nan 0 0 0 0 1 0 0\n"),
              "a.ply: line 15: cut off, or not a finite number");
    EXPECT_EQ(refused("a.ply", kPlyHeader + kPlyVertices + "99999999999 0 1 2\n"),
              "a.ply: line 18: cut off, or not a finite number");
    const auto with = [](const std::string& line) {
        return "ply\nformat ascii 1.0\ncomment none\n" + line + "\nend_header\n";
    };
    EXPECT_EQ(refused("a.ply", with("property float x")), "a.ply: line 4: a property must follow an element");
    EXPECT_EQ(refused("a.ply", with("element vertex -3")),
              "a.ply: line 4: the number of 'vertex' must be 0 or more");
    EXPECT_EQ(refused("a.ply", with("element vertex 3\nproperty quad x")),
              "a.ply: line 5: unknown type 'quad'");
    EXPECT_EQ(refused("a.ply", with("elephant vertex 3")),
              "a.ply: line 4: 'elephant vertex 3' does not belong into a PLY header");
    EXPECT_EQ(refused("a.ply", with("element vertex 3\nproperty float x")),
              "a.ply: line 6: the PLY header has no vertices with a property y");
    EXPECT_EQ(refused("a.ply", "ply\nformat ascii 1.0\ncomment a\ncomment b\n" + kPlyHeader.substr(21) +
                                   kPlyVertices + "3 0\n"),
              "a.ply: line 21: cut off, or not a finite number");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(refused("a.ply", binary_ply(nan, 3)),
              "a.ply: face 0 (counted from 0): vertex 0 is NaN or infinite; positions must be finite");
    const std::string whole = binary_ply(0, 3);
    for (std::size_t size = whole.size() - 1; size > whole.size() - 60; size -= 7) {
        EXPECT_NE(refused("a.ply", whole.substr(0, size)).find("cut off"), std::string::npos);
    }
    std::string huge = whole;
    huge.replace(huge.find("face 1"), 6, "face 4000000000");
    EXPECT_EQ(
        refused("a.ply", huge),
        "a.ply: line 12: cut off: the header promises 4000000000 of 'face', more than the file has bytes");
}

TEST_F(MeshFiles, off_errors) {
    EXPECT_EQ(refused("a.off", "hello\n"),
              "a.off: line 1: is not an OFF file (it must start with OFF or STOFF)");
    EXPECT_EQ(refused("a.off", "STOFF\n"), "a.off: line 1: is cut off after its first line");
    EXPECT_EQ(refused("a.off", "STOFF BINARY\n"),
              "a.off: line 1: only text OFF files are read, not 'BINARY'");
    EXPECT_EQ(refused("a.off", "STOFF\n3 1 0\n0 0 0 0 0\n"), "a.off: line 3: cut off: a vertex is missing");
    EXPECT_EQ(refused("a.off", "STOFF\n1 1 0\n0 0 0\n"),
              "a.off: line 3: the vertex has 3 numbers, must have 5");
    EXPECT_EQ(refused("a.off", "STOFF\n1 1 0\n0 0 inf 0 0\n"),
              "a.off: line 3: 'inf' is not finite; numbers must be finite");
    EXPECT_EQ(refused("a.off", "STOFF\n1 1 0\n0 0 0 0 0\n99999999999 0 0 0\n"),
              "a.off: line 4: a corner of the face is missing or no index");
    EXPECT_EQ(refused("a.off", "STOFF\n1 1 0\n0 0 0 0 0\n3 0 0 7\n"),
              "a.off: face 0 (counted from 0): names vertex 7, the file has 1 (counted from 0)");
}

TEST_F(MeshFiles, ply_in_double_far_from_zero_warns_of_lost_digits) {
    std::string header = kPlyHeader;
    header.replace(header.find("float x"), 7, "double x");
    const MeshFile file =
        load("f.ply", header + "100000 0 0 0 0 1 0 0\n100001 0 0 0 0 1 1 0\n100000 1 0 0 0 1 0 1\n3 0 1 2\n");
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_NE(file.warnings[0].find("single precision"), std::string::npos);
}

}  // namespace
}  // namespace relievo::mesh_file_test
