#include "ui/text/position_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/session/entry.h"
#include "core/session/face.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr int longestAxis = 20;

struct PositionText {
  Q_DECLARE_TR_FUNCTIONS(PositionText)
};

}  // namespace

QString positionText(const Session& session, std::size_t position) {
  const auto axisOf = [](const Position& at) {
    const Result<int> axis = axisEntry(at.axisDeg);
    return axis ? *axis : -1;
  };
  const auto own = session.positions.begin() + static_cast<std::ptrdiff_t>(position);
  const int axisDeg = axisOf(*own);
  if (axisDeg < 0) return orNotStated(shortLine(own->axisDeg, longestAxis)) + QChar(0x00b0);
  const auto before = std::count_if(session.positions.begin(), own,
                                    [&](const Position& other) { return axisOf(other) == axisDeg; });
  return positionText(axisDeg, 1 + static_cast<int>(before));
}

QString sightingText(int axisDeg, int repeat, int point, int round, int face) {
  return PositionText::tr("Axis at %1, point %2, round %3, %4")
      .arg(positionText(axisDeg, repeat))
      .arg(point)
      .arg(round)
      .arg(qText(faceName(face)));
}

}  // namespace alidade::ui
