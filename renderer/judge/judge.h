// Compares a method's layers Z and N, one method after the other, with the reference's image of one view.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/judge/error_units.h"
#include "renderer/judge/image_comparison.h"
#include "renderer/reference/reference.h"

namespace relievo {

class Judge {
  public:
    // `units`: one an object. Pixels within `reach` of a tear of the reference's image lie at a silhouette.
    Judge(ReferenceImage image, const Camera& camera, const glm::dvec3& scene_origin,
          std::span<const ErrorUnit> units, int reach = 2);
    Judge(ReferenceImage image, const Scene& scene, int reach = 2);

    const ReferenceImage& image() const { return image_; }
    bool at_silhouette(std::size_t pixel) const { return silhouettes_[pixel] != 0; }

    // `depth` and `normal` as Renderer::read_back gives them.
    ImageComparison compare(std::span<const float> depth, std::span<const float> normal) const;

    // Counts, into `result`, the pixels (at silhouettes as well) where the method missed, invented or is off
    // by more than a hundredth of the unit, and none of the reference's rays within 2e-3 pixels of the centre
    // or from eyes a float's last place beside it gives the method's answer: rounding cannot excuse them.
    // When more than `most` pixels are wrong, as many of them spread over the image are examined, and the
    // count is scaled up.
    void count_unexplained(const ReferenceSurface& surface, std::span<const float> depth,
                           ImageComparison& result, int most = 1 << 30) const;

    // What a picture of the errors shows of a pixel.
    struct PixelError {
        enum class Kind : std::uint8_t { nothing, both, missed, invented } kind = Kind::nothing;
        float depth = 0;  // over the unit, where both hit
    };
    std::vector<PixelError> errors(std::span<const float> depth) const;

  private:
    glm::dvec3 direction(int x, int y) const;
    bool agrees(std::uint32_t object, double reference, double method) const;
    std::vector<char> find_unexplained(const ReferenceSurface& surface, std::span<const float> depth,
                                       std::span<const std::size_t> pixels) const;
    bool explained(const ReferenceSurface& surface, int x, int y, double method) const;

    ReferenceImage image_;
    Camera camera_;
    glm::dvec3 origin_;
    std::vector<ErrorUnit> units_;
    std::vector<std::uint8_t> silhouettes_;
};

}  // namespace relievo
