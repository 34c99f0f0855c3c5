#include "core/wording/journal.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace alidade {

namespace {

constexpr std::array reasons{std::pair{journal_reasons::retyped, "retyped"},
                             std::pair{journal_reasons::suggestion, "suggestion accepted"},
                             std::pair{journal_reasons::cleared, "cleared"},
                             std::pair{journal_reasons::pasted, "pasted over"},
                             std::pair{journal_reasons::excluded, "excluded"},
                             std::pair{journal_reasons::usedAgain, "used again"},
                             std::pair{journal_reasons::deleted, "deleted"},
                             std::pair{journal_reasons::inserted, "inserted"},
                             std::pair{journal_reasons::moved, "moved to another position"},
                             std::pair{journal_reasons::imported, "imported"},
                             std::pair{journal_reasons::undone, "undone"},
                             std::pair{journal_reasons::sealed, "sealed"}};

std::string sealSentence(const Session& session, const Seal& seal) {
  const std::string when = timeText(seal.at) + " UTC by " + seal.by;
  const std::string text =
      seal.revision == 0 ? "Sealed " + when : "Revision " + std::to_string(seal.revision) + " sealed " + when;
  const std::size_t since = session.journal.size() - seal.entry - 1;
  if (since > 0)
    return text + "; " + (since == 1 ? std::string("one change") : std::to_string(since) + " changes") +
           " since: a revision that nobody has sealed.";
  return text + (isAsSealed(session, seal)
                     ? " and unchanged since."
                     : "; its content is not what was sealed, and the journal does not tell of the change.");
}

}  // namespace

std::string timeText(const std::string& at) {
  constexpr std::string_view shape = "0000-00-00T00:00:00Z";
  const bool isTime =
      at.size() == shape.size() && std::ranges::equal(at, shape, [](char letter, char wanted) {
        return wanted == '0' ? std::isdigit(static_cast<unsigned char>(letter)) != 0 : letter == wanted;
      });
  return isTime ? at.substr(0, 10) + ' ' + at.substr(11, 5) : at;
}

std::string reasonText(const JournalEntry& entry) {
  const auto found = std::ranges::find_if(reasons, [&](const auto& own) { return entry.why == own.first; });
  return found == reasons.end() ? entry.why : found->second;
}

std::string journalSummary(const Session& session) {
  std::string text;
  const auto say = [&](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
  if (const std::size_t changed = changedReadings(session); changed > 0)
    say(changed == 1 ? "One reading was changed after entry."
                     : std::to_string(changed) + " readings were changed after entry.");
  if (const auto broken = firstBrokenEntry(session.journal))
    say("The journal does not hold together from entry " + std::to_string(*broken + 1) +
        " on: it, or one before it, was changed outside this program.");
  if (const auto seal = sealOf(session.journal)) say(sealSentence(session, *seal));
  return text;
}

}  // namespace alidade
