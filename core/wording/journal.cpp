#include "core/wording/journal.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "core/base/phrase.h"

namespace alidade {

namespace {

constexpr std::array reasons{
    std::pair{journal_reasons::retyped, PHRASE_LATER("Phrase", "retyped")},
    std::pair{journal_reasons::suggestion, PHRASE_LATER("Phrase", "suggestion accepted")},
    std::pair{journal_reasons::cleared, PHRASE_LATER("Phrase", "cleared")},
    std::pair{journal_reasons::pasted, PHRASE_LATER("Phrase", "pasted over")},
    std::pair{journal_reasons::excluded, PHRASE_LATER("Phrase", "excluded")},
    std::pair{journal_reasons::usedAgain, PHRASE_LATER("Phrase", "used again")},
    std::pair{journal_reasons::deleted, PHRASE_LATER("Phrase", "deleted")},
    std::pair{journal_reasons::inserted, PHRASE_LATER("Phrase", "inserted")},
    std::pair{journal_reasons::moved, PHRASE_LATER("Phrase", "moved to another position")},
    std::pair{journal_reasons::imported, PHRASE_LATER("Phrase", "imported")},
    std::pair{journal_reasons::undone, PHRASE_LATER("Phrase", "undone")},
    std::pair{journal_reasons::sealed, PHRASE_LATER("Phrase", "sealed")}};

std::string sealSentence(const Session& session, const Seal& seal) {
  const std::string text = seal.revision == 0 ? Phrase::of("Sealed %1 UTC by %2", timeText(seal.at), seal.by)
                                              : Phrase::of("Revision %1 sealed %2 UTC by %3", seal.revision,
                                                           timeText(seal.at), seal.by);
  const std::size_t since = session.journal.size() - seal.entry - 1;
  if (since == 1) return Phrase::of("%1; one change since: a revision that nobody has sealed.", text);
  if (since > 1) return Phrase::of("%1; %2 changes since: a revision that nobody has sealed.", text, since);
  return isAsSealed(session, seal)
             ? Phrase::of("%1 and unchanged since.", text)
             : Phrase::of(
                   "%1; its content is not what was sealed, and the journal does not tell of the change.",
                   text);
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
  return found == reasons.end() ? entry.why : Phrase::of(found->second);
}

std::string journalSummary(const Session& session) {
  std::string text;
  const auto say = [&](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
  if (const std::size_t changed = changedReadings(session); changed > 0)
    say(changed == 1 ? Phrase::of("One reading was changed after entry.")
                     : Phrase::of("%1 readings were changed after entry.", changed));
  if (const auto broken = firstBrokenEntry(session.journal))
    say(
        Phrase::of("The journal does not hold together from entry %1 on: it, or one before it, was changed "
                   "outside this program.",
                   *broken + 1));
  if (const auto seal = sealOf(session.journal)) say(sealSentence(session, *seal));
  return text;
}

}  // namespace alidade
