#include "app/console/journal_text.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "app/console/json_text.h"
#include "app/console/text_layout.h"
#include "core/base/visible_text.h"
#include "core/wording/journal.h"

namespace alidade::console {

std::string journalText(const std::string& name, const Session& session) {
  std::string text = heading(name);
  if (session.journal.empty()) return text + "Nothing that stood was changed.\n";
  for (const JournalEntry& entry : session.journal) {
    std::string line = timeText(entry.at) + " UTC " + (entry.place.empty() ? "the session" : entry.place);
    if (!entry.point.empty()) line += " (point " + entry.point + ")";
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
  for (const JournalEntry& entry : session.journal)
    entries.push_back({{"at", entry.at},
                       {"by", entry.by},
                       {"place", entry.place},
                       {"axis_deg", entry.axis},
                       {"point", entry.point},
                       {"round", entry.round},
                       {"face", entry.face},
                       {"from", entry.from},
                       {"to", entry.to},
                       {"why", entry.why},
                       {"hash", entry.hash}});
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
