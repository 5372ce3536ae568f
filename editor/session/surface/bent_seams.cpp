#include "editor/session/surface/bent_seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

#include "editor/session/surface/seam_columns.h"
#include "editor/session/surface/seam_slopes.h"
#include "editor/session/surface/texel_classes.h"

namespace relievo {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

// A column past an end whose sides carry different shifts: the corner texels must make up for it.
struct OpenEnd {
    std::uint32_t gutter[2];
    std::uint32_t bend[2];  // of the texels beside them
};

class BentSeamFinder {
  public:
    BentSeamFinder(const Mesh& mesh, const MapGrid& grid, const UvBorders& borders,
                   const TexelClasses& classes, const std::vector<TexelSum>& sums)
        : mesh_(mesh), grid_(grid), classes_(classes) {
        for (const UvSeam& seam : borders.seams)
            if (seam.aligned) collect(seam);
        kept_.assign(bends_.size(), true);
        for (std::uint32_t i = 0; i < bends_.size(); ++i)
            for (const std::uint32_t gutter : bends_[i].gutter) claim(gutter, i);
        for (const TexelSum& sum : sums)
            for (const auto& [texel, weight] : sum) {
                in_equations_.insert(texel);
                if (const auto at = bend_of_.find(texel); at != bend_of_.end()) kept_[at->second] = false;
            }
        join_corners();
        while (drop_what_tears()) continue;
    }

    BentSeams found() const {
        BentSeams result;
        std::vector<bool> wanted(bends_.size(), false);
        for (std::uint32_t i = 0; i < bends_.size(); ++i) {
            const SeamBend& bend = bends_[i];
            wanted[i] = kept_[i] && (bend.lean != 0 || bend.bend[0] != 0 || bend.bend[1] != 0);
        }
        for (const SeamCorner& corner : corners_)
            if (holds(corner))
                for (const std::uint32_t i : corner.bend) wanted[i] = true;
        std::vector<std::uint32_t> place(bends_.size(), kNone);
        for (std::uint32_t i = 0; i < bends_.size(); ++i) {
            if (!wanted[i]) continue;
            place[i] = static_cast<std::uint32_t>(result.bends.size());
            result.bends.push_back(bends_[i]);
        }
        for (SeamCorner corner : corners_) {
            if (!holds(corner)) continue;
            for (std::uint32_t& bend : corner.bend) bend = place[bend];
            result.corners.push_back(corner);
        }
        return result;
    }

  private:
    // The plain case of copies: both texels at the border owned and free of others, both gutters their
    // copies.
    bool plain(const SeamColumn& c) const {
        return c.weight_in == 0.5 && c.a_in != c.a_out && classes_.owned(c.a_in) && classes_.owned(c.b_in) &&
               !classes_.owned(c.a_out) && !classes_.owned(c.b_out) && c.a_out != c.b_out &&
               classes_.root(c.a_in) == c.a_in && classes_.root(c.b_in) == c.b_in &&
               classes_.root(c.a_out) == c.b_in && classes_.root(c.b_out) == c.a_in;
    }

    void collect(const UvSeam& seam) {
        std::vector<SeamColumn> columns;
        for_each_column(seam, grid_, [&](const SeamColumn& column) { columns.push_back(column); });
        columns_.insert(columns_.end(), columns.begin(), columns.end());
        const SlopeWeights weights = slope_weights(mesh_, grid_, seam);
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const SeamColumn& c = columns[i];
            if (c.past_end || !plain(c)) continue;
            const bool more = i + 1 < columns.size() && plain(columns[i + 1]);
            const bool less = i > 0 && plain(columns[i - 1]);
            const SeamColumn &ahead = more ? columns[i + 1] : c, &behind = less ? columns[i - 1] : c;
            const std::int32_t times = more && less ? 1 : 2;  // the slope over one column or over two
            seam_of_.push_back(&seam);
            bends_.push_back({{c.a_in, c.b_in},
                              {c.a_out, c.b_out},
                              {ahead.a_in, ahead.b_in},
                              {behind.a_in, behind.b_in},
                              weights.lean,
                              {times * weights.bend[0], times * weights.bend[1]}});
        }
    }

    // A gutter that serves two columns serves neither.
    void claim(std::uint32_t gutter, std::uint32_t bend) {
        const auto [at, fresh] = bend_of_.try_emplace(gutter, bend);
        if (fresh) return;
        kept_[at->second] = false;
        kept_[bend] = false;
    }

    std::uint32_t bend_of(std::uint32_t texel) const {
        const auto at = bend_of_.find(texel);
        return at != bend_of_.end() && kept_[at->second] ? at->second : kNone;
    }
    const std::pair<std::uint32_t, std::uint32_t>* corner_of(std::uint32_t texel) const {
        const auto at = corner_of_.find(texel);
        return at != corner_of_.end() && holds(corners_[at->second.first]) ? &at->second : nullptr;
    }
    bool holds(const SeamCorner& corner) const {
        return std::all_of(corner.bend, corner.bend + 3, [&](std::uint32_t i) { return kept_[i]; });
    }

    std::optional<OpenEnd> open_end(const SeamColumn& c) const {
        const OpenEnd end{{c.a_out, c.b_out}, {bend_of(c.a_in), bend_of(c.b_in)}};
        const auto free = [&](std::uint32_t texel) {
            return !classes_.owned(texel) && !bend_of_.contains(texel) && !in_equations_.contains(texel);
        };
        if (!c.past_end || c.weight_in != 0.5 || end.bend[0] == kNone || end.bend[1] == kNone) return {};
        if (end.bend[0] == end.bend[1] || end.gutter[0] == end.gutter[1]) return {};
        if (!free(end.gutter[0]) || !free(end.gutter[1])) return {};
        return end;
    }

    // Three open ends that close a ring over three gutters.
    void join_corners() {
        std::map<std::uint32_t, std::vector<OpenEnd>> ends;
        for (const SeamColumn& column : columns_)
            if (const auto end = open_end(column))
                for (const std::uint32_t gutter : end->gutter) ends[gutter].push_back(*end);
        for (const auto& [gutter, at] : ends) {
            if (at.size() != 2 || corner_of_.contains(gutter)) continue;
            const auto other = [&, g = gutter](const OpenEnd& end) { return end.gutter[end.gutter[0] == g]; };
            add_corner({gutter, other(at[0]), other(at[1])}, ends);
        }
    }

    void add_corner(const std::array<std::uint32_t, 3>& gutters,
                    const std::map<std::uint32_t, std::vector<OpenEnd>>& ends) {
        SeamCorner corner{};
        std::array<const UvSeam*, 3> seams{};
        std::set<std::uint32_t> inside, bends;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = ends.find(gutters[k]);
            if (at == ends.end() || at->second.size() != 2 || corner_of_.contains(gutters[k])) return;
            if (classes_.root(gutters[k]) != classes_.root(gutters[0])) return;
            corner.gutter[k] = gutters[k];
            corner.bend[k] = kNone;
            for (const OpenEnd& end : at->second) {
                for (const std::uint32_t gutter : end.gutter)
                    if (std::find(gutters.begin(), gutters.end(), gutter) == gutters.end()) return;
                bends.insert(end.bend, end.bend + 2);
            }
            for (const std::uint32_t i : at->second[0].bend)  // the one that both ends at this gutter have
                for (const std::uint32_t j : at->second[1].bend)
                    if (i == j) corner.bend[k] = i;
            if (corner.bend[k] == kNone || in_corner_.contains(corner.bend[k])) return;
            seams[k] = seam_of_[corner.bend[k]];
            inside.insert(bends_[corner.bend[k]].inside, bends_[corner.bend[k]].inside + 2);
        }
        if (bends.size() != 3 || inside.size() != 3) return;
        const std::array<std::int32_t, 3> weights = vertex_weights(mesh_, seams);
        std::copy(weights.begin(), weights.end(), corner.weight);
        for (std::size_t k = 0; k < 3; ++k)  // the texel that the seam opposite does not touch
            for (const std::uint32_t texel : inside) {
                const std::uint32_t* opposite = bends_[corner.bend[k]].inside;
                if (texel != opposite[0] && texel != opposite[1]) corner.inside[k] = texel;
            }
        for (std::uint32_t k = 0; k < 3; ++k) {
            corner_of_[gutters[k]] = {static_cast<std::uint32_t>(corners_.size()), k};
            in_corner_.insert(corner.bend[k]);
        }
        corners_.push_back(corner);
    }

    // What a column says of values and shifts, as weights that must be 0 one by one: whether it does.
    enum class Kind { value, shift, corner };
    bool balanced(const SeamColumn& c) const {
        std::map<std::pair<Kind, std::uint32_t>, double> sum;
        const auto add = [&](std::uint32_t texel, double weight) {
            if (const auto* corner = corner_of(texel)) {
                sum[{Kind::corner, corner->first}] += weight;
                sum[{Kind::shift, corners_[corner->first].bend[corner->second]}] += weight;
                return;
            }
            sum[{Kind::value, classes_.root(texel)}] += weight;
            if (const std::uint32_t bend = bend_of(texel); bend != kNone) sum[{Kind::shift, bend}] += weight;
        };
        add(c.a_in, c.weight_in);
        add(c.a_out, c.weight_out);
        add(c.b_in, -c.weight_out);
        add(c.b_out, -c.weight_in);
        return std::all_of(sum.begin(), sum.end(),
                           [](const auto& term) { return std::abs(term.second) < 1e-9; });
    }

    bool drop_what_tears() {
        std::vector<std::uint32_t> torn;
        for (const SeamColumn& c : columns_) {
            const std::uint32_t texels[4] = {c.a_in, c.a_out, c.b_in, c.b_out};
            std::vector<std::uint32_t> shifts;
            for (const std::uint32_t texel : texels) {
                if (const std::uint32_t bend = bend_of(texel); bend != kNone) shifts.push_back(bend);
                if (const auto* corner = corner_of(texel))
                    shifts.insert(shifts.end(), corners_[corner->first].bend,
                                  corners_[corner->first].bend + 3);
            }
            if (!shifts.empty() && !balanced(c)) torn.insert(torn.end(), shifts.begin(), shifts.end());
        }
        for (const std::uint32_t bend : torn) kept_[bend] = false;
        return !torn.empty();
    }

    const Mesh& mesh_;
    const MapGrid& grid_;
    const TexelClasses& classes_;
    std::vector<SeamColumn> columns_;     // of all aligned seams
    std::vector<SeamBend> bends_;         // of every plain column, those without a shift too
    std::vector<const UvSeam*> seam_of_;  // of each bend
    std::vector<bool> kept_;
    std::unordered_map<std::uint32_t, std::uint32_t> bend_of_;  // by gutter
    std::unordered_set<std::uint32_t> in_equations_;
    std::vector<SeamCorner> corners_;
    std::unordered_map<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>>
        corner_of_;                      // by gutter: corner, place in it
    std::set<std::uint32_t> in_corner_;  // bends
};

}  // namespace

BentSeams find_bent_seams(const Mesh& mesh, const MapGrid& grid, const UvBorders& borders,
                          const TexelClasses& classes, const std::vector<TexelSum>& sums) {
    return BentSeamFinder(mesh, grid, borders, classes, sums).found();
}

}  // namespace relievo
