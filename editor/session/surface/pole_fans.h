// Vertices at which a seam ends, several islands meet, as at a cube's corners, or many end in points, as at
// the poles of a globe: about them an island is narrower than a few texels, so that what lies beyond its
// seams is not its neighbour's alone but that of islands further round, and of those across. The faces about
// such a vertex are laid out in a plane, by angle and distance, turned evenly where they close, and what a
// texel should hold is read off a surface through all their texels near it (height_fit.h).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <vector>

#include "brushes/surface.h"
#include "editor/session/surface/uv_borders.h"

namespace relievo {

class TexelClasses;

class PoleFans {
  public:
    // Of every vertex at which one or at least three seams end that are not aligned, and whose faces are one
    // fan. All outlive this.
    PoleFans(const Mesh& mesh, const MapGrid& grid, const UvBorders& borders, const TexelClasses& classes);

    // What a texel outside `face` should hold that lies, in the texel space of the face, at `at`: empty where
    // that is not within a few texels of such a vertex, or no texels are there to tell.
    std::vector<SeamExtension::Source> sources(std::uint32_t face, glm::dvec2 at) const;

  private:
    // A face about the vertex: its corner there in texels, and from a step in texels to polar coordinates.
    struct Sector {
        std::uint32_t face;
        glm::dvec2 corner;
        glm::dvec2 next, previous;  // texels from the corner to the two others
        glm::dvec2 along, out;      // of the same in the face's plane, along the first and away from it
        double start;               // radians

        glm::dvec2 barycentric(glm::dvec2 step) const;
    };
    struct Site {
        std::uint32_t texel;
        glm::dvec2 at;
    };
    struct Fan {
        std::vector<Sector> sectors;
        double turn = 1;     // that closes the angles, or keeps an open fan within a circle
        double spacing = 0;  // world units: the longest step of a texel about the vertex
        std::vector<Site> sites;

        glm::dvec2 place(const Sector& sector, glm::dvec2 step) const;
    };

    std::size_t corner_at(std::uint32_t face, std::uint32_t vertex) const;
    std::uint32_t next_of(std::uint32_t face, std::uint32_t vertex) const;
    std::uint32_t previous_of(std::uint32_t face, std::uint32_t vertex) const;
    std::vector<std::uint32_t> in_order(std::uint32_t vertex, const std::vector<std::uint32_t>& faces) const;
    std::optional<Fan> fan_about(std::uint32_t vertex, const std::vector<std::uint32_t>& faces) const;
    void find_sites(Fan& fan) const;
    static std::vector<SeamExtension::Source> height_at(const Fan& fan, glm::dvec2 place);

    const Mesh& mesh_;
    const MapGrid& grid_;
    const TexelClasses& classes_;
    std::vector<Fan> fans_;
    std::multimap<std::uint32_t, std::pair<std::size_t, std::size_t>> of_face_;  // fan, sector
};

}  // namespace relievo
