#pragma once

#include <QStringList>

#include "core/base/phrase.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

/// "collimation, trunnion axis tilt": entries in a row, separated as usual in the language of the thread.
inline QString listText(const QStringList& entries) {
  return entries.join(qText(Phrase::of(", ")));
}

}  // namespace alidade::ui
