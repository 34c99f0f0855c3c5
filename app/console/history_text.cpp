#include "app/console/history_text.h"

#include <algorithm>

#include "app/console/text_layout.h"
#include "core/adjustment/result/acceptance.h"
#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/quantity_text.h"
#include "core/base/visible_text.h"
#include "core/series/history/history_sentences.h"

namespace alidade::console {

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string inBrackets(const std::string& title, const std::string& unit) {
  return unit.empty() ? title : title + " (" + unit + ")";
}

std::string marksOf(const History& history, std::size_t index) {
  std::vector<std::string> marks;
  const ControlChart::Point& point = history.chart.points[index];
  if (std::ranges::any_of(history.steps, [&](const HistoryStep& step) { return step.first == index; }))
    marks.emplace_back("step");
  if (history.oddValue == index) marks.emplace_back("stands apart");
  if (point.isOut) marks.emplace_back("outside 3 u");
  if (point.isEwmaOut) marks.emplace_back("average outside");
  return listed(marks);
}

std::string valuesTable(const History& history, const HistoryNumbers& numbers) {
  const bool apart =
      std::ranges::any_of(history.values, [](const DatedValue& value) { return value.apart != value.u; });
  Rows rows{{"date", inBrackets("value", numbers.heading()), "u"}};
  if (apart) rows.front().emplace_back("u apart");
  rows.front().insert(rows.front().end(), {"EWMA", "± limit", "", ""});
  for (std::size_t i = 0; i < history.values.size(); ++i) {
    const DatedValue& value = history.values[i];
    const ControlChart::Point& point = history.chart.points[i];
    std::vector<std::string> row{visibleText(value.date), numbers.number(value.value),
                                 numbers.number(value.u)};
    if (apart) row.push_back(numbers.number(value.apart));
    row.push_back(numbers.number(point.ewma));
    row.push_back(numbers.number(point.ewmaLimit));
    rows.push_back(std::move(row));
  }
  std::string table = alignedColumns(rows);
  // Remarks after each row, flush left outside the columns.
  std::string marked;
  std::size_t line = 0;
  for (std::size_t from = 0; from < table.size(); ++line) {
    const std::size_t end = table.find('\n', from);
    marked += table.substr(from, end - from);
    if (const std::string marks = line > 0 ? marksOf(history, line - 1) : ""; !marks.empty())
      marked += "  " + marks;
    marked += '\n';
    from = end + 1;
  }
  return marked;
}

std::string chanceCell(double chance) {
  return chance < 0.0005 ? "< 0.001" : fixedText(chance, 3);
}

std::string sentencesText(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += paragraph(sentence);
  return text;
}

std::string limitsLine(const History& history, const HistoryNumbers& numbers) {
  if (history.values.size() < 2) return "";
  return paragraph("Control limits: the mean " + numbers.withUnit(history.mean.value) +
                   " ± 3 u of each value; by the moving range that is seen ± " +
                   numbers.withUnit(limitSigmas * history.chart.seenSigma) + ".");
}

std::string seriesText(const History& history, const std::string& unit) {
  const HistoryNumbers numbers(history, unit);
  return valuesTable(history, numbers) + "\n" + limitsLine(history, numbers) +
         sentencesText(historySentences(history, unit));
}

std::string stableText(const History& history) {
  if (!history.stable) return "one value";
  if (*history.stable) return "stable";
  return history.course == Course::Constant ? "scatters" : courseName(history.course);
}

std::string quantitiesTable(const DeviceHistory& device) {
  Rows rows{{"", "values", "mean", "u", "", "χ²", "p", "per year", "u", ""}};
  for (const QuantityHistory& quantity : device.quantities) {
    const History& history = quantity.history;
    const HistoryNumbers numbers(history, quantity.unit);
    const auto& trend = history.trend;
    rows.push_back({quantityName(quantity.id), std::to_string(history.values.size()),
                    numbers.number(history.mean.value), numbers.number(history.mean.u), numbers.heading(),
                    history.chance ? fixedText(history.chiSquare, 1) : "",
                    history.chance ? chanceCell(*history.chance) : "",
                    trend ? numbers.number(trend->perYear) : "", trend ? numbers.number(trend->u) : "",
                    stableText(history)});
  }
  return alignedColumns(rows);
}

/// Each epoch compared with the next, and the first with the last.
std::string congruencesText(const DeviceHistory& device) {
  Rows rows{{"from", "to", "Δd changes (mm)", "± U", "p", "", "device, T", "of", "p", ""}};
  for (const Congruence& congruence : device.congruences) {
    const bool isNext = congruence.second == congruence.first + 1;
    if (!isNext && (congruence.first != 0 || congruence.second + 1 != device.epochs.size())) continue;
    const int decimals = decimalsFor(congruence.expanded);
    std::vector<std::string> row{visibleText(device.epochs[congruence.first].date),
                                 visibleText(device.epochs[congruence.second].date),
                                 displayText(congruence.difference, decimals),
                                 displayText(congruence.expanded, decimals),
                                 chanceCell(congruence.chance),
                                 congruence.hasChanged ? "changed" : ""};
    if (const auto& test = congruence.device) {
      row.push_back(fixedText(test->statistic, 1));
      row.push_back(std::to_string(test->ids.size()));
      row.push_back(chanceCell(test->chance));
      row.emplace_back(test->chance < leastChance ? "differs" : "");
    }
    rows.push_back(std::move(row));
  }
  return alignedColumns(rows) + "\n" +
         paragraph(
             "Δd, measured, with every effect that the sessions do not share. Device: (O1 − O2)/2 and the "
             "radii "
             "by the readings alone, with their full covariance, wherever the theodolite stood.");
}

std::string deviceName(const DeviceHistory& device) {
  if (device.name.empty() && device.serial.empty()) return "Device without a name";
  if (device.serial.empty()) return visibleText(device.name);
  return visibleText(device.name.empty() ? "Device" : device.name) + ", serial number " +
         visibleText(device.serial);
}

}  // namespace

std::string historyText(const std::string& name, const ValueTable& table, const History& history) {
  std::string text = heading(name) + "\n" + seriesText(history, table.unit);
  for (const std::string& remark : table.remarks) text += paragraph("Note: " + remark + ".");
  return text;
}

std::string historyText(const std::string& name, const DeviceHistories& histories) {
  std::string text = heading(name);
  for (const DeviceHistory& device : histories.devices) {
    text += "\n" + deviceName(device) + ": Δd, measured\n\n";
    text += seriesText(device.quantities.front().history, device.quantities.front().unit);
    text += paragraph(sharedSentence(device));
    text += "\nQuantities\n\n" + quantitiesTable(device);
    if (!device.congruences.empty()) text += "\nEpochs compared\n\n" + congruencesText(device);
  }
  return text;
}

}  // namespace alidade::console
