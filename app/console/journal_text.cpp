#include "app/console/journal_text.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "app/console/text_layout.h"
#include "core/answers/json_text.h"
#include "core/base/visible_text.h"
#include "core/wording/journal.h"

namespace alidade::console {

namespace {

const char* stateName(CheckedSeal::State state) {
  switch (state) {
    case CheckedSeal::State::Held:
      return "held";
    case CheckedSeal::State::Changed:
      return "changed";
    case CheckedSeal::State::Unchecked:
      break;
  }
  return "unchecked";
}

}  // namespace

std::string journalText(const std::string& name, const Session& session, const JournalCheck& check) {
  std::string text = heading(name);
  const std::string summary = journalSummary(session, check);
  if (session.journal.empty())
    return text + (summary.empty() ? "No entry was changed after it was recorded.\n" : paragraph(summary));
  for (const JournalEntry& entry : session.journal) {
    std::string line = timeText(entry.at) + " UTC " + (entry.place.empty() ? "the session" : entry.place);
    if (!entry.point.empty()) line += " (point " + entry.point + ")";
    if (entry.why == journal_reasons::imported)
      line += ": imported from " + visibleText(entry.to);
    else if (entry.why == journal_reasons::sealed)
      line += ": sealed as revision " + visibleText(entry.from) + ", SHA-256 " + visibleText(entry.to);
    else
      line += ": " + quotation(entry.from) + " became " + quotation(entry.to) + ", " + reasonText(entry);
    if (!entry.by.empty()) line += ", " + entry.by;
    text += paragraph(line, 2);
  }
  return text + "\n" + paragraph(summary.empty() ? "The journal is whole." : summary);
}

std::string journalJson(const std::string& name, const Session& session, const JournalCheck& check) {
  using Json = nlohmann::ordered_json;
  Json entries = Json::array();
  for (const JournalEntry& entry : session.journal) {
    Json& json = entries.emplace_back(Json::object());
    for (const JournalField& field : journalFields) json[field.key] = entry.*field.text;
  }
  Json contradictions = Json::array();
  for (const JournalContradiction& one : check.contradictions)
    contradictions.push_back({{"place", one.place}, {"journal", one.told}, {"file", one.held}});
  Json seals = Json::array();
  for (const CheckedSeal& one : check.seals)
    seals.push_back({{"at", one.seal.at},
                     {"by", one.seal.by},
                     {"revision", one.seal.revision},
                     {"sha256", one.seal.digest},
                     {"state", stateName(one.state)}});
  Json sealed = nullptr;
  if (const auto seal = sealOf(session.journal))
    sealed = {{"at", seal->at},
              {"by", seal->by},
              {"revision", seal->revision},
              {"unchanged", isAsSealed(session, *seal)}};
  return answerText({{"session", name},
                     {"whole", check.holds()},
                     {"changed_readings", changedReadings(session)},
                     {"contradictions", std::move(contradictions)},
                     {"sealed", std::move(sealed)},
                     {"seals", std::move(seals)},
                     {"entries", std::move(entries)}});
}

}  // namespace alidade::console
