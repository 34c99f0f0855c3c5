#include "app/console/instrument_text.h"

#include "app/console/text_layout.h"
#include "core/series/instrument_check/check_statement.h"

namespace alidade::console {

std::string instrumentText(const std::string& name, const CheckIdentity& identity,
                           const InstrumentCheck& check, const std::vector<Finding>& findings) {
  std::string text = heading(name) + statementText(checkVerdict(check, findings)) +
                     statementText(identityTable(identity)) + statementText(stationsTable(check));
  for (const StationCheck& station : check.stations)
    for (const Statement& details : stationDetails(station)) text += statementText(details);
  return text + findingsText(findings);
}

}  // namespace alidade::console
