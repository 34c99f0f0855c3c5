#include "ui/charts/plotting/row_choice.h"

#include <QCoreApplication>

#include "core/session/face.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {
namespace {

struct RowEntriesText {
  Q_DECLARE_TR_FUNCTIONS(RowEntriesText)
};

}  // namespace

std::vector<LegendEntry> rowEntries(const PlotStyle& style, const RowKinds& kinds, const RowChoice& choice,
                                    bool areApart) {
  std::vector<LegendEntry> entries;
  const bool hasTwo = !kinds.faces.empty() && kinds.faces.back() == 2;
  if (hasTwo && choice.face != 1) {
    Marker marker = style.marker(0, MarkerShape::Circle);
    marker.colour = style.text;
    marker.inside = style.background;
    marker.filled = false;
    marker.struck = true;
    entries.push_back({marker, qText(faceName(2))});
  }
  if (areApart && kinds.rounds.size() > 1 && !choice.round)
    entries.push_back({{}, RowEntriesText::tr("rounds side by side")});
  if (const QString only = choice.text(); !only.isEmpty()) entries.push_back({{}, only});
  return entries;
}

}  // namespace alidade::ui
