// Procedural heights as the reference asks for them (renderer/procedural): virtual texels without period.
#pragma once

#include <memory>

#include "renderer/procedural/procedural_source.h"
#include "renderer/reference/cell_heights.h"

namespace relievo::reference {

class ProceduralCells final : public CellHeights {
  public:
    explicit ProceduralCells(std::shared_ptr<const ProceduralSource> source) : source_(std::move(source)) {}

    void cover(int axis, double low, double high, Cells& cells) const override;
    HeightRange range(const Cells& cells) const override;
    std::int64_t cut(const Cells& cells, int axis) const override;
    CellCounts counts(const Cells& single) const override;

  private:
    std::shared_ptr<const ProceduralSource> source_;
};

}  // namespace relievo::reference
