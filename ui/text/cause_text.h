#pragma once

#include <QString>

#include "core/statement/gap.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/effect_name.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

// The words for causes in `core/wording` and `core/statement`, as `QString`.

inline QString causeName(const std::string& id) {
  return qText(alidade::causeName(id));
}
inline QString causeTitle(const std::string& id) {
  return qText(alidade::causeTitle(id));
}
/// The names as a list: "a, b or c". `last` separates the last two, blanks included: " or ".
inline QString causeNames(const std::vector<std::string>& ids, const QString& last) {
  return qText(alidade::causeNames(ids, last.toStdString()));
}
/// The verdict in a few words: "One cause: collimation".
inline QString gapHeadline(const Diagnosis& diagnosis) {
  return qText(headlineOf(diagnosis));
}

}  // namespace alidade::ui
