// The fingerprint of a base mesh that journals carry: dabs address its faces, so they mean nothing on another
// one.
#pragma once

#include <cstdint>

#include "renderer/scene/mesh.h"

namespace relievo {

// 64-bit FNV-1a of positions, normals, texture coordinates and faces, counts included, little endian.
std::uint64_t mesh_hash(const Mesh& mesh);

}  // namespace relievo
