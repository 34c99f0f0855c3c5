#include "app/console/journal_text.h"

#include <nlohmann/json.hpp>

#include "app/console/text_layout.h"
#include "core/answers/json_text.h"
#include "core/statement/journal.h"
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
  std::string summary = journalSummary(session, check);
  if (summary.empty())
    summary =
        session.journal.empty() ? "No entry was changed after it was recorded." : "The journal is whole.";
  if (session.journal.empty()) return heading(name) + paragraph(summary);
  const auto placeOf = [](const JournalEntry& entry) {
    const std::string place = entry.place.empty() ? "the session" : entry.place;
    return entry.point.empty() ? place : place + " (point " + entry.point + ")";
  };
  return heading(name) + statementText(journalTable(session, summary, placeOf));
}

std::string journalJson(const std::string& name, const Session& session, const JournalCheck& check,
                        const std::string& digest) {
  using Json = nlohmann::ordered_json;
  Json entries = Json::array();
  for (const JournalEntry& entry : session.journal) {
    Json& json = entries.emplace_back(Json::object());
    for (const JournalField& field : journalFields) json[field.key] = entry.*field.text;
  }
  Json contradictions = Json::array();
  for (const JournalContradiction& one : check.contradictions)
    contradictions.push_back({{"place", one.place}, {"journal", one.recorded}, {"file", one.held}});
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
                     {"entries", std::move(entries)}},
                    digest);
}

}  // namespace alidade::console
