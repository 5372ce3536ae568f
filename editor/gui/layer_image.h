// The numbers that a view shows, one or three a pixel, taken from a renderer's layers, and their colours.
#pragma once

#include <cstdint>
#include <vector>

#include "editor/gui/colour_scale.h"
#include "editor/gui/views.h"
#include "editor/gui/window.h"
#include "editor/session/live_reference.h"
#include "editor/session/session.h"

namespace relievo::gui {

constexpr Rgb kNothing{23, 24, 27};    // where the ray hits nothing
constexpr Rgb kNotKnown{84, 88, 98};   // where the reference has not been yet; darker where seen aslant
constexpr Rgb kMissed{255, 0, 200};    // the reference hits, the method does not
constexpr Rgb kInvented{0, 220, 255};  // the method hits, the reference does not

// How the numbers become colours.
struct Palette {
    View view = View::normals;
    ColourScale scale = ColourScale::heat(1);
    const ReferencePicture* reference = nullptr;  // of the view `error`
    std::vector<double> units;                    // likewise: an error of 1, one an object
};

// Depth errors of the pixels whose reference is known, over the unit.
struct ErrorSummary {
    std::size_t pixels = 0, missed = 0, invented = 0;  // pixels: where both hit
    double median = 0, p99 = 0, largest = 0;
};

class LayerImage {
  public:
    PixelSize size() const { return size_; }
    const std::vector<std::uint8_t>& rgba() const { return rgba_; }

    void reset(PixelSize size, View view);  // forgets all
    // Takes the window that renderer.trace_layers() traced last.
    void collect(const Renderer& renderer, const PixelRect& window, RayCount count, const Session& session);
    void paint(const PixelRect& rows, const Palette& palette);

    // A number that the share `rank` of the pixels does not exceed; 0 while there are none.
    double quantile(double rank) const;
    // Of every `stride`th pixel each way.
    ErrorSummary errors(const Palette& palette, int stride) const;

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
               static_cast<std::size_t>(x);
    }
    void put(const std::vector<float>& from, const PixelRect& window, std::size_t channels,
             std::vector<float>& to) const;
    Rgb colour(int x, int y, const Palette& palette) const;
    Rgb error_colour(int x, int y, const Palette& palette) const;

    PixelSize size_;
    View view_ = View::normals;
    std::size_t channels_ = 1;
    std::vector<float> values_;  // NaN: nothing to show
    std::vector<float> facing_;  // of the view `error`: how much the surface faces the camera, [0, 1]
    std::vector<std::uint8_t> rgba_;
};

// The unit of errors, one an object: its amplitude, or where that is 0 its size.
std::vector<double> error_units(const Scene& scene);

}  // namespace relievo::gui
