#include "app/console/journal_text.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "app/console/text_layout.h"
#include "core/answers/json_text.h"
#include "core/base/visible_text.h"
#include "core/wording/journal.h"

namespace alidade::console {

std::string journalText(const std::string& name, const Session& session) {
  std::string text = heading(name);
  if (session.journal.empty()) return text + "Nothing that stood was changed.\n";
  for (const JournalEntry& entry : session.journal) {
    std::string line = timeText(entry.at) + " UTC " + (entry.place.empty() ? "the session" : entry.place);
    if (!entry.point.empty()) line += " (point " + entry.point + ")";
    if (entry.why == journal_reasons::imported)
      line += ": imported from " + visibleText(entry.to);
    else
      line += ": " + quotation(entry.from) + " became " + quotation(entry.to) + ", " + reasonText(entry);
    if (!entry.by.empty()) line += ", " + entry.by;
    text += paragraph(line, 2);
  }
  const std::string summary = journalSummary(session);
  return text + "\n" + paragraph(summary.empty() ? "The journal is whole." : summary);
}

std::string journalJson(const std::string& name, const Session& session) {
  using Json = nlohmann::ordered_json;
  Json entries = Json::array();
  for (const JournalEntry& entry : session.journal) {
    Json& json = entries.emplace_back(Json::object());
    for (const JournalField& field : journalFields) json[field.key] = entry.*field.text;
  }
  Json sealed = nullptr;
  if (const auto seal = sealOf(session.journal))
    sealed = {{"at", seal->at},
              {"by", seal->by},
              {"revision", seal->revision},
              {"unchanged", isAsSealed(session, *seal)}};
  return jsonText({{"session", name},
                   {"whole", !firstBrokenEntry(session.journal)},
                   {"changed_readings", changedReadings(session)},
                   {"sealed", std::move(sealed)},
                   {"entries", std::move(entries)}});
}

}  // namespace alidade::console
