#include "app/console/history_text.h"

#include "app/console/text_layout.h"
#include "core/series/history/history_sentences.h"
#include "core/series/history/history_statement.h"

namespace alidade::console {

std::string historyText(const std::string& name, const ValueTable& table, const History& history) {
  std::string text = heading(name) + statementText(valueTable(history, table.unit));
  for (const std::string& remark : table.remarks) text += paragraph("Note: " + remark + ".");
  return text;
}

std::string historyText(const std::string& name, const DeviceHistories& histories) {
  std::string text = heading(name);
  for (const DeviceHistory& device : histories.devices) {
    const QuantityHistory& intersection = device.quantities.front();
    text += "\n" + heading(deviceName(device) + ": " + quantityName(intersection.id));
    for (const Statement& statement : {valueTable(intersection.history, intersection.unit),
                                       sessionTable(device), quantityTable(device), congruenceTable(device)})
      text += statementText(statement);
  }
  return text;
}

std::string historyText(const std::string& name, const InstrumentHistories& histories,
                        const std::string& today) {
  std::string text = heading(name);
  for (const InstrumentHistory& instrument : histories.instruments) {
    text += "\n" + heading(instrumentName(instrument)) + statementText(recordTable(instrument, today));
    for (const QuantityHistory& quantity : instrument.quantities) {
      Statement table = valueTable(quantity.history, quantity.unit);
      table.title = quantityName(quantity.id);
      text += statementText(table);
    }
  }
  return text;
}

}  // namespace alidade::console
