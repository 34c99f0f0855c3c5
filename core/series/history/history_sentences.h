#pragma once

#include <string>
#include <vector>

#include "core/series/history/device_history.h"
#include "core/series/history/history.h"

namespace alidade {

/// Numbers of one quantity, all with the decimals and the power of ten that show the least of its u with two
/// digits.
class HistoryNumbers {
 public:
  /// `unit`: may be empty.
  HistoryNumbers(const History& history, std::string unit);

  std::string number(double value) const;                     ///< "1.308"
  std::string withUnit(double value) const;                   ///< "1.308 mm", "6.6743 × 10⁻¹¹ m³"
  std::string withUncertainty(double value, double u) const;  ///< "1.308 mm ± 0.021 mm"
  std::string ratePerYear(double value, double u) const;      ///< "0.12 mm/a ± 0.02 mm/a"
  /// What a number is multiplied with before it is shown: a power of ten.
  double scale() const;
  std::string heading() const;  ///< "mm", "10⁻¹¹ m³", or empty: above a column of numbers

 private:
  int m_power = 0, m_decimals = 3;
  std::string m_unit;  ///< with the power of ten before it

  std::string withUnit(double value, int decimals, const std::string& suffix) const;
};

/// What the history says, for people: mean, χ², what became of the quantity, what else it may be. Standard
/// uncertainties.
std::vector<std::string> historySentences(const History& history, const std::string& unit);

/// What all sessions of a device share, and what therefore was left out where they are compared.
std::string sharedSentence(const DeviceHistory& device);

/// Whether Δd has changed between two epochs, and whether the rest of the device has.
std::vector<std::string> congruenceSentences(const std::vector<Epoch>& epochs, const Congruence& congruence);

/// What people call a quantity by its id: "Δd as found", "O1, x", "trunnion axis tilt: tilt".
std::string quantityName(const std::string& id);

/// What people call a course: "constant", "in steps".
std::string courseName(Course course);

/// Why a session takes no part: `title` has no date.
std::string undatedSentence(const std::string& title);

}  // namespace alidade
