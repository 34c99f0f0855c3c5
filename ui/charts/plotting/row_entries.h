#pragma once

#include <vector>

#include "ui/charts/plotting/legend.h"
#include "ui/charts/plotting/row_choice.h"

namespace alidade::ui {

/// What a legend says of rounds and faces: that face 2 is struck through, that marks stand side by side, and
/// what alone is drawn. Nothing where there is one round in one face.
std::vector<LegendEntry> rowEntries(const PlotStyle& style, const RowKinds& kinds, const RowChoice& choice,
                                    bool areApart);

}  // namespace alidade::ui
