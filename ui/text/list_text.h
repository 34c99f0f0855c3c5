#pragma once

#include <QStringList>

#include "core/base/phrase.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

/// The entries, separated as usual in the thread's language: "collimation, trunnion axis tilt".
inline QString listText(const QStringList& entries) {
  return entries.join(qText(Phrase::of(", ")));
}

}  // namespace alidade::ui
