#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/series/history/history.h"

namespace alidade {

/// One quantity of a device or an instrument over time.
struct QuantityHistory {
  /// Of a device: "intersection" (measured), "intersection_of_fit", a length of `Epoch::lengths`, or "effect:
  /// parameter" of a cause that was found. Of an instrument: an effect, "effect: parameter", or
  /// "line_of_sight".
  std::string id;
  std::string unit;
  History history;
};

/// Collects quantities that only some sessions or records have, in the order of their first occurrence.
class FoundQuantities {
 public:
  /// A value without a finite u > 0 is left out.
  void add(const std::string& id, const std::string& unit, const DatedValue& value);
  /// The unit of the quantity; absent before its first value.
  std::optional<std::string> unitOf(const std::string& id) const;
  void moveTo(std::vector<QuantityHistory>& quantities, double coverage);

 private:
  struct Quantity {
    std::string id, unit;
    std::vector<DatedValue> values;
  };
  std::vector<Quantity> m_found;
};

/// Sets the baseline of every quantity's control chart: the first `baseline` sessions or records; 0: all.
/// `days`: the day of each session or record, ascending. If a quantity is absent from some sessions or
/// records, its baseline ends with its last value on or before the last day of the baseline.
void setBaseline(std::vector<QuantityHistory>& quantities, std::size_t baseline,
                 const std::vector<double>& days);

}  // namespace alidade
