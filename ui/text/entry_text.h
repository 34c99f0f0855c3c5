#pragma once

#include <QString>
#include <QStringList>
#include <string>

#include "core/base/angle_text.h"
#include "core/base/phrase.h"

namespace alidade::ui {

inline QString qText(const std::string& text) {
  return QString::fromStdString(text);
}

/// A typed angle shown in `unit`: `3415224` as 341°52′24″, with the decimals it needs (`decimalsOf`), at
/// least `leastDecimals` of seconds. An invalid angle is shown as typed.
QString shownAngle(const std::string& typed, CircleUnit unit, int leastDecimals = 0);

/// The entries, separated as usual in the thread's language: "collimation, trunnion axis tilt".
inline QString listText(const QStringList& entries) {
  return entries.join(qText(Phrase::of(", ")));
}

}  // namespace alidade::ui
