// The fingerprint of a base mesh that journals carry: dabs address its faces, so they mean nothing on another
// one.
#include "editor/session/mesh_hash.h"

#include <bit>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace relievo {
namespace {

struct Fnv1a {
    std::uint64_t value = 0xcbf29ce484222325u;

    void add(std::uint32_t word) {
        for (int byte = 0; byte < 4; ++byte) {
            value ^= (word >> (8 * byte)) & 0xffu;
            value *= 0x100000001b3u;
        }
    }
    void add(float number) { add(std::bit_cast<std::uint32_t>(number)); }
};

}  // namespace

std::uint64_t mesh_hash(const Mesh& mesh) {
    Fnv1a hash;
    hash.add(static_cast<std::uint32_t>(mesh.positions.size()));
    for (const glm::vec3& p : mesh.positions) hash.add(p.x), hash.add(p.y), hash.add(p.z);
    for (const glm::vec3& n : mesh.normals) hash.add(n.x), hash.add(n.y), hash.add(n.z);
    hash.add(static_cast<std::uint32_t>(mesh.uvs.size()));
    for (const glm::vec2& uv : mesh.uvs) hash.add(uv.x), hash.add(uv.y);
    hash.add(static_cast<std::uint32_t>(mesh.faces.size()));
    for (const Mesh::Face& face : mesh.faces) {
        for (std::uint32_t index : face.position) hash.add(index);
        for (std::uint32_t index : face.uv) hash.add(index);
    }
    return hash.value;
}

}  // namespace relievo
