#include "core/series/history/record_history.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "core/series/history/history_date.h"
#include "core/session/entry.h"
#include "core/session/other_circle.h"

namespace alidade {

namespace {

/// Records without serial numbers are of one instrument if their names are equal.
bool areOfOneInstrument(const InstrumentRecord& one, const InstrumentRecord& other) {
  return one.serial.empty() && other.serial.empty() ? one.name == other.name : one.serial == other.serial;
}

double dayOf(const InstrumentRecord& record) {
  const Result<HistoryDate> date = parseHistoryDate(record.date);
  return date ? date->day : 0;
}

bool isOfElevations(const InstrumentRecord& record) {
  const auto circle = verticalCircleEntry(record.verticalCircle);
  return circle && *circle == VerticalCircle::Elevation;
}

/// `asOfZenith`: the sizes are converted to those on a zenith circle.
void addConstants(FoundQuantities& constants, const InstrumentRecord& record, bool asOfZenith) {
  const auto add = [&](const std::string& id, const std::string& unit, const std::string& value,
                       const std::string& sigma) {
    const Result<double> read = parseNumber(value), u = parseNumber(sigma);
    if (read && u) constants.add(id, unit, {record.date, dayOf(record), *read, *u, *u, {}, 0, 0});
  };
  const bool isOther = asOfZenith && isOfElevations(record);
  for (const KnownSize& size : isOther ? onOtherCircle(record.known) : record.known)
    add(size.parameter.empty() ? size.effect : size.effect + ": " + size.parameter, size.unit,
        size.value.empty() ? "0" : size.value, size.sigma);
  const LineOfSight& sight = record.lineOfSight;
  if (!sight.offsetMm.empty()) add("line_of_sight", "mm", sight.offsetMm, sight.sigmaMm);
}

}  // namespace

InstrumentHistories instrumentHistories(const std::vector<KeptRecord>& records) {
  InstrumentHistories histories;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto isSame = [&](const KeptRecord& other) { return other.record == records[i].record; };
    const auto end = records.begin() + static_cast<std::ptrdiff_t>(i);
    if (const auto first = std::find_if(records.begin(), end, isSame); first != end) {
      histories.copies.emplace_back(i, static_cast<std::size_t>(first - records.begin()));
      continue;
    }
    auto place = std::ranges::find_if(histories.instruments, [&](const InstrumentHistory& one) {
      return areOfOneInstrument(one.records.front().record, records[i].record);
    });
    if (place == histories.instruments.end())
      place = histories.instruments.insert(place, InstrumentHistory());
    place->records.push_back(records[i]);
  }
  for (InstrumentHistory& instrument : histories.instruments) {
    std::ranges::stable_sort(instrument.records, {},
                             [](const KeptRecord& kept) { return dayOf(kept.record); });
    instrument.name = instrument.records.back().record.name;
    instrument.serial = instrument.records.back().record.serial;
    FoundQuantities constants;
    const auto ofElevations = std::ranges::count_if(
        instrument.records, [](const KeptRecord& kept) { return isOfElevations(kept.record); });
    const bool areOfBoth = ofElevations > 0 && ofElevations < std::ssize(instrument.records);
    for (const KeptRecord& kept : instrument.records) addConstants(constants, kept.record, areOfBoth);
    constants.moveTo(instrument.quantities, usualCoverage);
  }
  return histories;
}

void setBaseline(InstrumentHistory& instrument, std::size_t records) {
  std::vector<double> days;
  for (const KeptRecord& kept : instrument.records) days.push_back(dayOf(kept.record));
  setBaseline(instrument.quantities, records, days);
}

}  // namespace alidade
