#include "core/wording/journal.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "core/base/list_text.h"
#include "core/base/phrase.h"
#include "core/base/problem.h"
#include "core/effects/catalogue.h"
#include "core/wording/effect_name.h"

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
    std::pair{journal_reasons::sealed, PHRASE_LATER("Phrase", "sealed")},
    std::pair{journal_reasons::explained, PHRASE_LATER("Phrase", "reason stated")}};

/// The note of the excluded row that an entry is about; null if there is no such row or it has no note.
const std::string* noteOf(const JournalEntry& entry, const Session& session) {
  for (std::size_t position = 0; position < session.positions.size(); ++position) {
    if (!entry.place.starts_with(Place{.position = position}.path() + ".readings[")) continue;
    const std::vector<Reading>& rows = session.positions[position].readings;
    const auto row = std::ranges::find_if(rows, [&](const Reading& one) {
      return one.excluded && one.point == entry.point && one.round == entry.round && one.face == entry.face;
    });
    return row == rows.end() || row->note.empty() ? nullptr : &row->note;
  }
  return nullptr;
}

/// The stated reason of an entry; empty if none is stated.
std::string statedOf(const JournalEntry& entry, const Session& session) {
  if (entry.why == journal_reasons::excluded) {
    const std::string* note = noteOf(entry, session);
    return note ? *note : std::string();
  }
  const std::vector<JournalEntry>& journal = session.journal;
  const auto own = std::ranges::find_if(journal, [&](const JournalEntry& one) { return &one == &entry; });
  return own == journal.end() ? std::string()
                              : explanationOf(journal, static_cast<std::size_t>(own - journal.begin()));
}

/// Replaces the identifiers in `trunnion_tilt: 12 ± 2 arcsec` or `plane_tilt tilt about x: …` by names.
std::string knownSizeText(const std::string& text) {
  const std::size_t colon = text.find(':'), blank = std::min(text.find(' '), colon);
  if (colon == std::string::npos || !effectById(text.substr(0, blank))) return text;
  std::vector<std::string> names{effectName(text.substr(0, blank))};
  if (blank < colon) names.push_back(parameterName(text.substr(blank + 1, colon - blank - 1)));
  return listed(names) + text.substr(colon);
}

/// Replaces effect identifiers separated by ", " by names.
std::string effectsText(const std::string& text) {
  constexpr std::string_view separator = ", ";
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    names.push_back(effectName(text.substr(begin, end - begin)));
    begin = std::min(end + separator.size(), text.size());
  }
  return listed(names);
}

std::string sealName(const Seal& seal) {
  return seal.revision == 0
             ? Phrase::of("Sealed %1 UTC by %2", timeText(seal.at), seal.by)
             : Phrase::of("Revision %1 sealed %2 UTC by %3", seal.revision, timeText(seal.at), seal.by);
}

/// `since` is the number of journal entries after the seal.
std::string sealSentence(const CheckedSeal& checked, std::size_t since) {
  using State = CheckedSeal::State;
  const std::string text = sealName(checked.seal);
  if (checked.state == State::Changed)
    return since == 0 ? Phrase::of(
                            "%1; its content differs from what was sealed, and the journal does not record "
                            "the change.",
                            text)
                      : Phrase::of(
                            "%1; its content was changed outside this program since: the sealed content "
                            "cannot be rebuilt from the journal.",
                            text);
  if (checked.state == State::Unchecked)
    return Phrase::of("%1; the sealed content cannot be rebuilt from the journal and is not checked.", text);
  if (since == 0) return Phrase::of("%1 and unchanged since.", text);
  if (since == 1) return Phrase::of("%1; one change since: the current revision is not sealed.", text);
  return Phrase::of("%1; %2 changes since: the current revision is not sealed.", text, since);
}

/// Sentences on the last seal, and on earlier seals whose content was changed.
std::vector<std::string> sealSentences(const std::vector<CheckedSeal>& seals,
                                       const std::vector<JournalEntry>& journal) {
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < seals.size(); ++i)
    if (i + 1 == seals.size() || seals[i].state == CheckedSeal::State::Changed)
      sentences.push_back(sealSentence(seals[i], changesSince(seals[i].seal, journal)));
  return sentences;
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

std::string reasonText(const JournalEntry& entry, const Session& session) {
  const auto found = std::ranges::find_if(reasons, [&](const auto& own) { return entry.why == own.first; });
  if (found == reasons.end()) return entry.why;
  const std::string text = Phrase::of(found->second);
  const std::string stated = statedOf(entry, session);
  return stated.empty() ? text : Phrase::of("%1: %2", text, stated);
}

std::string contentText(const JournalEntry& entry, const std::string& text) {
  if (entry.place == "model.effects") return effectsText(text);
  const bool isKnown =
      entry.place.starts_with("instrument.known[") || entry.place.starts_with("device.known[");
  return isKnown ? knownSizeText(text) : text;
}

std::string sealState(const std::vector<JournalEntry>& journal) {
  const auto seal = sealOf(journal);
  if (!seal) return {};
  const std::size_t since = changesSince(*seal, journal);
  const std::string name = sealName(*seal);
  if (since == 0) return name;
  return since == 1 ? Phrase::of("%1, with one unsealed change since", name)
                    : Phrase::of("%1, with %2 unsealed changes since", name, since);
}

std::string contradictionText(const JournalContradiction& one) {
  if (one.recorded.empty())
    return Phrase::of("%1: the file holds “%2”, but the journal records no change.", one.place, one.held);
  if (one.held.empty())
    return Phrase::of("%1: the journal says “%2”, and the file holds nothing.", one.place, one.recorded);
  return Phrase::of("%1: the journal says “%2”, and the file holds “%3”.", one.place, one.recorded, one.held);
}

std::string journalSummary(const Session& session) {
  return journalSummary(session, checkJournal(session));
}

std::string journalSummary(const Session& session, const JournalCheck& check) {
  constexpr std::size_t mostListed = 5;
  std::string text;
  const auto say = [&](const std::string& sentence) { text += (text.empty() ? "" : " ") + sentence; };
  if (const std::size_t changed = changedReadings(session); changed > 0)
    say(changed == 1 ? Phrase::of("One reading was changed after entry.")
                     : Phrase::of("%1 readings were changed after entry.", changed));
  if (check.broken)
    say(
        Phrase::of("The journal is broken from entry %1 on: this entry or an earlier one was changed outside "
                   "this program.",
                   *check.broken + 1));
  if (!check.contradictions.empty()) say(Phrase::of("Changed outside this program:"));
  for (std::size_t i = 0; i < std::min(mostListed, check.contradictions.size()); ++i)
    say(contradictionText(check.contradictions[i]));
  if (check.contradictions.size() > mostListed)
    say(Phrase::of("Further places: %1.", check.contradictions.size() - mostListed));
  if (check.backwards)
    say(
        Phrase::of("Entry %1 is earlier than the entry before it: the clock was set back, or one of the two "
                   "times was changed.",
                   *check.backwards + 1));
  for (const std::string& sentence : sealSentences(check.seals, session.journal)) say(sentence);
  return text;
}

}  // namespace alidade
