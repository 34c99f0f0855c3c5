#include "core/series/history/record_history.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "core/series/history/history_date.h"

namespace alidade {

namespace {

bool haveOneInstrument(const InstrumentRecord& one, const InstrumentRecord& other) {
  return one.serial.empty() && other.serial.empty() ? one.name == other.name : one.serial == other.serial;
}

double dayOf(const InstrumentRecord& record) {
  const Result<HistoryDate> date = parseHistoryDate(record.date);
  return date ? date->day : 0;
}

/// Values by constant, in the order of their first occurrence.
class Constants {
 public:
  void add(const KeptRecord& kept) {
    for (const KnownSize& size : kept.record.known)
      add(kept, size.parameter.empty() ? size.effect : size.effect + ": " + size.parameter, size.unit,
          size.value.empty() ? "0" : size.value, size.sigma);
    const LineOfSight& sight = kept.record.lineOfSight;
    if (!sight.offsetMm.empty()) add(kept, "line_of_sight", "mm", sight.offsetMm, sight.sigmaMm);
  }

  std::vector<QuantityHistory> histories() {
    std::vector<QuantityHistory> quantities;
    for (Constant& constant : m_constants)
      quantities.push_back({constant.id, constant.unit, historyOf(std::move(constant.values))});
    return quantities;
  }

 private:
  struct Constant {
    std::string id, unit;
    std::vector<DatedValue> values;
  };
  std::vector<Constant> m_constants;

  void add(const KeptRecord& kept, const std::string& id, const std::string& unit, const std::string& value,
           const std::string& sigma) {
    const Result<double> read = parseNumber(value), u = parseNumber(sigma);
    if (!read || !u || !(*u > 0)) return;
    auto place = std::ranges::find(m_constants, id, &Constant::id);
    if (place == m_constants.end()) place = m_constants.insert(place, {id, unit, {}});
    place->values.push_back({kept.record.date, dayOf(kept.record), *read, *u, *u, {}, 0, 0});
  }
};

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
      return haveOneInstrument(one.records.front().record, records[i].record);
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
    Constants constants;
    for (const KeptRecord& kept : instrument.records) constants.add(kept);
    instrument.quantities = constants.histories();
  }
  return histories;
}

void setBaseline(InstrumentHistory& instrument, std::size_t records) {
  records = std::min(records, instrument.records.size());
  const double last = records > 0 ? dayOf(instrument.records[records - 1].record) : 0;
  for (QuantityHistory& quantity : instrument.quantities) {
    const std::vector<DatedValue>& values = quantity.history.values;
    const auto until =
        std::ranges::count_if(values, [&](const DatedValue& value) { return value.day <= last; });
    setBaseline(quantity.history, records == 0 || values.size() == instrument.records.size()
                                      ? records
                                      : static_cast<std::size_t>(until));
  }
}

}  // namespace alidade
