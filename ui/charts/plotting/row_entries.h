#pragma once

#include <vector>

#include "ui/charts/plotting/legend.h"
#include "ui/charts/plotting/row_choice.h"

namespace alidade::ui {

/// Legend entries on rounds and faces: the stroke of face 2, rounds side by side, and the choice if only some
/// are drawn. Empty for one round in face 1.
std::vector<LegendEntry> rowEntries(const PlotStyle& style, const RowKinds& kinds, const RowChoice& choice,
                                    bool areApart);

}  // namespace alidade::ui
