#include "ui/text/form_text.h"

#include "core/wording/findings.h"
#include "core/wording/form_sentence.h"
#include "ui/text/cause_text.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

QString aboutForm(const FoundForm& form) {
  const std::string alike = lookAlikesSentence(form, causeNameInCore), clean = cleanRangeSentence(form);
  return qText(alike.empty() ? clean : clean.empty() ? alike : inTurn(alike, clean));
}

}  // namespace alidade::ui
