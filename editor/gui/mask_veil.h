// The mask over one renderer's picture, as sculptors know it: what it protects is shown darker. A layer of the
// window alone: no shader, no saved picture and no journal knows of it.
//
// It keeps the picture as it was traced, and where on the map each pixel lies, so that another mask only needs
// to be painted.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "brushes/height_map.h"
#include "editor/gui/window.h"
#include "renderer/renderer.h"
#include "renderer/scene/scene.h"

namespace relievo::gui {

class MaskVeil {
  public:
    PixelSize size() const { return size_; }
    bool knows_all() const { return known_ > 0 && known_ == places_.size(); }
    // As last painted; 4 bytes a pixel, sRGB-encoded, row 0 at the top.
    const std::vector<std::uint8_t>& rgba() const { return painted_; }

    void reset(PixelSize size);  // forgets all, its memory too; 0 x 0: nothing is left
    // Takes the window that renderer.trace_layers() traced last. Window and renderer are of size().
    void collect(const Renderer& renderer, const PixelRect& window);
    // Takes the picture under the veil: the window's pixels alone, row by row.
    void take(const std::vector<std::uint8_t>& rgba, const PixelRect& window);
    // `mask`: of the scene's first object; null: the picture without it.
    void paint(const PixelRect& window, const HeightMap* mask, Wrap wrap);

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
               static_cast<std::size_t>(x);
    }

    PixelSize size_;
    std::vector<glm::vec2> places_;  // uv on the first object; infinite elsewhere; NaN: not traced yet
    std::size_t known_ = 0;          // of them, those traced
    std::vector<std::uint8_t> clear_, painted_;
};

}  // namespace relievo::gui
