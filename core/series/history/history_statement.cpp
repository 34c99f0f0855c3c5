#include "core/series/history/history_statement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/series/history/history_sentences.h"

namespace alidade {

namespace {

using Role = Statement::Column::Role;
using Cells = std::vector<std::string>;

std::string withUnit(const std::string& title, const std::string& unit) {
  return unit.empty() ? title : title + " (" + unit + ")";
}

std::string chanceCell(double chance) {
  return chance < 0.0005 ? "< 0.001" : displayText(chance, 3);
}

std::string marksOf(const History& history, std::size_t index) {
  Cells marks;
  const ControlChart::Point& point = history.chart.points[index];
  if (std::ranges::any_of(history.steps, [&](const HistoryStep& step) { return step.first == index; }))
    marks.push_back(Phrase::of("step"));
  if (history.oddValue == index) marks.push_back(Phrase::of("outlier"));
  if (point.isOut) marks.push_back(Phrase::of("outside"));
  if (point.isEwmaOut) marks.push_back(Phrase::of("EWMA outside"));
  return listed(marks);
}

std::string limitsSentence(const History& history, const HistoryNumbers& numbers) {
  const ControlChart& chart = history.chart;
  const std::string centre = numbers.withUnit(chart.centre);
  if (!std::isfinite(chart.seenSigma))
    return Phrase::of("Control limits: %1 ± three standard uncertainties of each value.", centre);
  return Phrase::of(
      "Control limits: %1 ± three standard uncertainties of each value, without the part common to all "
      "values; from the observed moving range: ± %2.",
      centre, numbers.withUnit(limitSigmas * chart.seenSigma));
}

std::string toleranceSentence(const History& history, const HistoryNumbers& numbers) {
  return Phrase::of("Tolerance of the latest session: ± %1.", numbers.exact(*history.tolerance));
}

std::string courseText(const History& history) {
  if (!history.stable) return Phrase::of("one value");
  if (*history.stable) return Phrase::of("stable");
  return history.course == Course::Constant ? Phrase::of("scatters") : courseName(history.course);
}

std::string nameOf(const std::string& typedName, const std::string& typedSerial,
                   const std::string& withoutName) {
  const std::string name = visibleText(typedName), serial = visibleText(typedSerial);
  if (name.empty() && serial.empty()) return withoutName;
  if (serial.empty()) return name;
  return name.empty() ? Phrase::of("serial number %1", serial)
                      : Phrase::of("%1, serial number %2", name, serial);
}

std::string changeText(const Congruence& congruence) {
  if (congruence.hasChanged) return Phrase::of("changed");
  return congruence.device && congruence.device->chance < leastChance ? Phrase::of("device changed") : "";
}

/// The O1 and O2 of sessions on different pillars cannot be compared.
std::string pillarSentence() {
  return Phrase::of(
      "O1 and O2 refer to the theodolite: compare them only between set-ups on the same pillar.");
}

}  // namespace

Statement valueTable(const History& history, const std::string& unit) {
  const HistoryNumbers numbers(history, unit);
  Statement statement{.id = "history",
                      .title = Phrase::of("Values"),
                      .columns = {{"date", Phrase::of("Date"), Role::Name},
                                  {"value", withUnit(Phrase::of("value"), numbers.heading())},
                                  {"expanded", "± U"},
                                  {"shewhart", Phrase::of("± limit")},
                                  {"ewma", "EWMA"},
                                  {"limit", Phrase::of("± EWMA limit")},
                                  {"remark", "", Role::Remark}},
                      .rows = {},
                      .sentences = historySentences(history, unit)};
  for (std::size_t i = 0; i < history.values.size(); ++i) {
    const DatedValue& value = history.values[i];
    const ControlChart::Point& point = history.chart.points[i];
    statement.rows.push_back(
        {{visibleText(value.date), numbers.number(value.value), numbers.number(value.expanded),
          numbers.number(point.shewhart), numbers.number(point.ewma), numbers.number(point.ewmaLimit),
          marksOf(history, i)}});
  }
  if (history.tolerance)
    statement.sentences.insert(statement.sentences.begin(), toleranceSentence(history, numbers));
  if (history.values.size() > 1)
    statement.sentences.insert(statement.sentences.begin(), limitsSentence(history, numbers));
  return statement;
}

Statement sessionTable(const DeviceHistory& device) {
  Statement statement{.id = "sessions",
                      .title = Phrase::of("Sessions"),
                      .columns = {{"date", Phrase::of("Date"), Role::Name},
                                  {"session", Phrase::of("Session"), Role::Remark},
                                  {"instrument", Phrase::of("Instrument"), Role::Word},
                                  {"intersection", "Δd ± U"},
                                  {"verdict", Phrase::of("Verdict"), Role::Word},
                                  {"condition", "", Role::Text}},
                      .rows = {},
                      .sentences = {sharedSentence(device)}};
  for (const Epoch& epoch : device.epochs) {
    const std::string& instrument =
        epoch.instrumentSerial.empty() ? epoch.instrument : epoch.instrumentSerial;
    statement.rows.push_back({{visibleText(epoch.date), visibleText(epoch.title),
                               instrument.empty() ? "—" : visibleText(instrument), intersectionText(epoch),
                               epoch.judgement.verdict, epoch.judgement.condition}});
  }
  return statement;
}

Statement quantityTable(const DeviceHistory& device) {
  Statement statement{
      .id = "quantities",
      .title = Phrase::of("Quantities"),
      .columns = {{"quantity", Phrase::of("Quantity"), Role::Name},
                  {"values", Phrase::of("Values")},
                  {"mean", Phrase::of("Weighted mean")},
                  {"chi_square", "χ²"},
                  {"p", "p"},
                  {"trend", Phrase::of("Trend")},
                  {"course", Phrase::of("Course"), Role::Word}},
      .rows = {},
      .sentences = {pillarSentence()},
      .note = Phrase::of("Each ± is an %1. All but “Δd, measured” follow from the readings alone.",
                         plusMinusText(device.quantities.front().history))};
  for (const QuantityHistory& quantity : device.quantities) {
    const History& history = quantity.history;
    const HistoryNumbers numbers(history, quantity.unit);
    const auto& trend = history.trend;
    statement.rows.push_back(
        {{quantityName(quantity.id), std::to_string(history.values.size()),
          numbers.withUncertainty(history.mean.value, history.mean.expanded),
          history.chance ? displayText(history.chiSquare, 1) : "—",
          history.chance ? chanceCell(*history.chance) : "—",
          trend ? numbers.ratePerYear(trend->perYear, trend->expanded) : "—", courseText(history)}});
  }
  return statement;
}

Statement congruenceTable(const DeviceHistory& device) {
  Statement statement{
      .id = "congruences",
      .title = Phrase::of("Sessions compared"),
      .columns = {{"from", Phrase::of("From"), Role::Name},
                  {"to", Phrase::of("To"), Role::Word},
                  {"difference", Phrase::of("Δd changes by")},
                  {"p", "p"},
                  {"device", Phrase::of("Device: T, number")},
                  {"p_device", "p"},
                  {"change", "", Role::Word}},
      .rows = {},
      .note = Phrase::of("Each session is compared with the next, and the first with the last. Δd, measured, "
                         "has its expanded uncertainty; effects common to both sessions cancel. Device: d "
                         "holds the m changes of (O1 − O2)/2 and of the radii, from the readings alone; T = "
                         "dᵀC⁻¹d with the full covariance C of both fits.")};
  for (const Congruence& congruence : device.congruences) {
    const bool isNext = congruence.second == congruence.first + 1;
    if (!isNext && (congruence.first != 0 || congruence.second + 1 != device.epochs.size())) continue;
    const auto& test = congruence.device;
    statement.rows.push_back(
        {{visibleText(device.epochs[congruence.first].date),
          visibleText(device.epochs[congruence.second].date),
          lengthWithUncertainty(congruence.difference, congruence.expanded, decimalsFor(congruence.expanded)),
          chanceCell(congruence.chance),
          test ? Phrase::of("%1, %2", displayText(test->statistic, 1), test->ids.size()) : "—",
          test ? chanceCell(test->chance) : "—", changeText(congruence)}});
  }
  if (statement.rows.empty()) statement.note.clear();
  return statement;
}

std::vector<std::string> quantitySentences(const DeviceHistory& device, const QuantityHistory& quantity) {
  std::vector<std::string> sentences = historySentences(quantity.history, quantity.unit);
  if (quantity.id == "intersection") sentences.push_back(sharedSentence(device));
  if (quantity.id.starts_with("o1_") || quantity.id.starts_with("o2_")) sentences.push_back(pillarSentence());
  return sentences;
}

std::string deviceName(const DeviceHistory& device) {
  return nameOf(device.name, device.serial, Phrase::of("device without a name"));
}

std::string instrumentName(const InstrumentHistory& instrument) {
  return nameOf(instrument.name, instrument.serial, Phrase::of("instrument without a name"));
}

Statement recordTable(const InstrumentHistory& instrument, const std::string& today) {
  Statement statement{.id = "records",
                      .title = Phrase::of("Records"),
                      .columns = {{"date", Phrase::of("Date"), Role::Name},
                                  {"due", Phrase::of("Next check due"), Role::Word},
                                  {"horizontal", Phrase::of("σ horizontal")},
                                  {"vertical", Phrase::of("σ vertical")},
                                  {"state", "", Role::Word},
                                  {"file", Phrase::of("File"), Role::Remark}},
                      .rows = {},
                      .sentences = instrument.leftOut};
  for (std::size_t i = 0; i < instrument.records.size(); ++i) {
    const InstrumentRecord& record = instrument.records[i].record;
    const bool isLast = i + 1 == instrument.records.size();
    const std::string& next = isLast ? today : instrument.records[i + 1].record.date;
    const auto sigma = [](const std::string& text) { return text.empty() ? "—" : visibleText(text) + "″"; };
    const bool isLate = !record.due.empty() && record.due < next;
    statement.rows.push_back({{visibleText(record.date), record.due.empty() ? "—" : visibleText(record.due),
                               sigma(record.sigmaHorizontalArcsec), sigma(record.sigmaVerticalArcsec),
                               !isLate  ? ""
                               : isLast ? Phrase::of("overdue")
                                        : Phrase::of("checked late"),
                               visibleText(instrument.records[i].file)}});
  }
  return statement;
}

std::string intersectionText(const Epoch& epoch) {
  const IntersectionEstimate& found = epoch.intersection;
  return lengthWithUncertainty(found.value, found.expanded, decimalsFor(found.expanded));
}

}  // namespace alidade
