#include "editor/session/surface/seam_table.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "editor/session/surface/bent_seams.h"
#include "editor/session/surface/owned_texels.h"
#include "editor/session/surface/seam_columns.h"
#include "editor/session/surface/seam_equations.h"
#include "editor/session/surface/seam_extension.h"
#include "editor/session/surface/seam_settling.h"
#include "editor/session/surface/texel_classes.h"
#include "editor/session/surface/texel_triangle.h"
#include "editor/session/surface/uv_borders.h"

namespace relievo {
namespace {

// A texel that could stand in for a free one.
struct Offer {
    std::uint32_t free;
    std::int64_t distance;  // squared, texels
    std::uint32_t source;

    bool operator<(const Offer& o) const {
        return std::tie(free, distance, source) < std::tie(o.free, o.distance, o.source);
    }
};

class SeamTableBuilder {
  public:
    SeamTableBuilder(const Mesh& mesh, const MapGrid& grid, const OwnedTexels& owned)
        : mesh_(mesh), grid_(grid), owned_(owned), classes_(owned), borders_(find_uv_borders(mesh, grid)) {}

    SeamTable build() {
        copy_across_edges();
        collect_equations();
        extend_past_borders();
        SeamTable table;
        for (const auto& [texel, root] : classes_.members()) table.copies.push_back({texel, root});
        std::sort(table.copies.begin(), table.copies.end(), [](const SeamCopy& a, const SeamCopy& b) {
            return std::tie(a.source, a.gutter) < std::tie(b.source, b.gutter);
        });
        table.equations = equations(sums_, classes_);
        BentSeams bent = find_bent_seams(mesh_, grid_, borders_, classes_, sums_);
        table.bends = std::move(bent.bends);
        table.corners = std::move(bent.corners);
        table.extensions = extend_over_seams(mesh_, grid_, borders_, classes_);
        return table;
    }

  private:
    void for_each_aligned_column(const std::function<void(const UvSeam&, const SeamColumn&)>& visit) const {
        for (const UvSeam& seam : borders_.seams) {
            if (seam.aligned)
                for_each_column(seam, grid_, [&](const SeamColumn& column) { visit(seam, column); });
        }
    }

    // Both gutters of a column whose insides are owned and whose outsides are not: the plain case, nearly all
    // of them.
    void copy_across_edges() {
        for_each_aligned_column([&](const UvSeam&, const SeamColumn& c) {
            if (!owned_(c.a_in) || !owned_(c.b_in) || owned_(c.a_out) || owned_(c.b_out)) return;
            if (!owned_(classes_.root(c.a_out))) classes_.join(c.a_out, c.b_in);
            if (!owned_(classes_.root(c.b_out))) classes_.join(c.b_out, c.a_in);
        });
    }

    void collect_equations() {
        std::vector<SeamColumn> open;
        for_each_aligned_column([&](const UvSeam&, const SeamColumn& column) {
            if (!reduced(column_sum(column), classes_).empty()) open.push_back(column);
        });
        for (const SeamColumn& column : settle(std::move(open), grid_, classes_))
            sums_.push_back(column_sum(column));
        for (const UvSeam& seam : borders_.seams) {
            if (!seam.aligned) add_seam_samples(seam, grid_, sums_);
        }
    }

    // Gives a value to every texel that filtering reads, that no face owns and that no equation determines.
    void extend_past_borders() {
        std::vector<std::uint32_t> unknowns;
        for (const TexelSum& sum : sums_) {
            for (const auto& [texel, weight] : reduced(sum, classes_)) {
                if (!owned_(texel)) unknowns.push_back(texel);
            }
        }
        std::sort(unknowns.begin(), unknowns.end());
        std::vector<Offer> offers;
        for (const UvSide& side : borders_.open) offer_along(side, unknowns, offers);
        for (const UvSeam& seam : borders_.seams) {
            if (!seam.aligned) continue;
            offer_along(seam.a, unknowns, offers);
            offer_along(seam.b, unknowns, offers);
        }
        std::sort(offers.begin(), offers.end());
        for (std::size_t i = 0; i < offers.size(); ++i) {
            if (i == 0 || offers[i].free != offers[i - 1].free)
                classes_.join(offers[i].free, offers[i].source);
        }
    }

    void offer_along(const UvSide& side, const std::vector<std::uint32_t>& unknowns,
                     std::vector<Offer>& offers) const {
        const TexelTriangle triangle = texel_triangle(mesh_, side.face, grid_);
        const std::vector<double> at = cell_crossings(side);
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            const glm::dvec2 p = side.from + (side.to - side.from) * ((at[i] + at[i + 1]) / 2);
            const BilinearTaps taps = bilinear_taps(grid_, p);
            for (std::size_t k = 0; k < 4; ++k) {
                const std::uint32_t root = classes_.root(taps.texel[k]);
                if (taps.weights()[k] < 1e-9 || owned_(root)) continue;
                if (std::binary_search(unknowns.begin(), unknowns.end(), root)) continue;
                const auto x = static_cast<std::int64_t>(std::floor(p.x)) + static_cast<std::int64_t>(k & 1);
                const auto y = static_cast<std::int64_t>(std::floor(p.y)) + static_cast<std::int64_t>(k >> 1);
                if (const auto best = nearest_owned(triangle, x, y)) {
                    offers.push_back({root, best->distance, best->source});
                }
            }
        }
    }

    // The nearest texel of the face within two texels of (x, y), else the nearest of any face.
    std::optional<Offer> nearest_owned(const TexelTriangle& triangle, std::int64_t x, std::int64_t y) const {
        std::optional<Offer> best, best_other;
        for (std::int64_t j = y - 2; j <= y + 2; ++j) {
            const TexelSpan span = triangle.columns(j);
            for (std::int64_t i = x - 2; i <= x + 2; ++i) {
                const std::uint32_t texel = grid_.index(i, j);
                if (!owned_(texel)) continue;
                const Offer offer{0, (i - x) * (i - x) + (j - y) * (j - y), classes_.root(texel)};
                auto& slot = i >= span.first && i <= span.last ? best : best_other;
                if (!slot || offer < *slot) slot = offer;
            }
        }
        return best ? best : best_other;
    }

    const Mesh& mesh_;
    MapGrid grid_;
    const OwnedTexels& owned_;
    TexelClasses classes_;
    UvBorders borders_;
    std::vector<TexelSum> sums_;
};

}  // namespace

SeamTable build_seam_table(const Mesh& mesh, const MapGrid& grid, const OwnedTexels& owned) {
    return SeamTableBuilder(mesh, grid, owned).build();
}

SeamTable build_seam_table(const Mesh& mesh, int width, int height, Wrap wrap) {
    const MapGrid grid{width, height, wrap};
    return build_seam_table(mesh, grid, OwnedTexels(mesh, grid));
}

}  // namespace relievo
