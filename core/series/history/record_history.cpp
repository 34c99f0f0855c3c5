#include "core/series/history/record_history.h"

#include <algorithm>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/effects/known_sizes.h"
#include "core/series/history/history_date.h"
#include "core/series/history/history_sentences.h"
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

/// The catalogue's parameter of this effect and name, whatever the unit; null if there is none.
const EffectParameter* cataloguedParameter(const KnownSize& size) {
  const Effect* effect = effectById(size.effect);
  if (!effect) return nullptr;
  const auto isIt = [&](const EffectParameter& each) {
    return findParameter(size.effect, size.parameter, each.unit) == &each;
  };
  const auto found = std::ranges::find_if(effect->parameters, isIt);
  return found == effect->parameters.end() ? nullptr : &*found;
}

/// "effect: parameter"; the effect alone if the catalogue has only one parameter of it, named or not.
std::string idOf(const KnownSize& size) {
  const bool isOnly = cataloguedParameter(size) && effectById(size.effect)->parameters.size() == 1;
  return isOnly || size.parameter.empty() ? size.effect : size.effect + ": " + size.parameter;
}

/// Collects the constants of an instrument's records. A size in another unit than that of the catalogue, or
/// else of the first such size, is left out.
class ConstantsOfRecords {
 public:
  /// `asOfZenith`: the sizes are converted to those on a zenith circle.
  void add(const KeptRecord& kept, bool asOfZenith) {
    const InstrumentRecord& record = kept.record;
    const bool isOther = asOfZenith && isOfElevations(record);
    for (const KnownSize& size : isOther ? onOtherCircle(record.known) : record.known) {
      const std::string id = idOf(size);
      const EffectParameter* parameter = cataloguedParameter(size);
      const std::string unit =
          parameter ? std::string(parameter->unit) : m_constants.unitOf(id).value_or(size.unit);
      if (size.unit == unit)
        add(record, id, unit, size.value.empty() ? "0" : size.value, size.sigma);
      else
        m_leftOut.push_back(
            Phrase::of("%1 states %2 in the unit %3, not in %4: the value is left out until it is converted.",
                       visibleText(kept.file), quantityName(id), quotation(size.unit), quotation(unit)));
    }
    const LineOfSight& sight = record.lineOfSight;
    if (!sight.offsetMm.empty()) add(record, "line_of_sight", "mm", sight.offsetMm, sight.sigmaMm);
  }

  void moveTo(InstrumentHistory& instrument) {
    m_constants.moveTo(instrument.quantities, usualCoverage);
    instrument.leftOut = std::move(m_leftOut);
  }

 private:
  FoundQuantities m_constants;
  std::vector<std::string> m_leftOut;

  void add(const InstrumentRecord& record, const std::string& id, const std::string& unit,
           const std::string& value, const std::string& sigma) {
    const Result<double> read = parseNumber(value), u = parseNumber(sigma);
    if (read && u) m_constants.add(id, unit, {record.date, dayOf(record), *read, *u, *u, {}, 0, 0});
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
    ConstantsOfRecords constants;
    const auto ofElevations = std::ranges::count_if(
        instrument.records, [](const KeptRecord& kept) { return isOfElevations(kept.record); });
    const bool areOfBoth = ofElevations > 0 && ofElevations < std::ssize(instrument.records);
    for (const KeptRecord& kept : instrument.records) constants.add(kept, areOfBoth);
    constants.moveTo(instrument);
  }
  return histories;
}

void setBaseline(InstrumentHistory& instrument, std::size_t records) {
  std::vector<double> days;
  for (const KeptRecord& kept : instrument.records) days.push_back(dayOf(kept.record));
  setBaseline(instrument.quantities, records, days);
}

}  // namespace alidade
