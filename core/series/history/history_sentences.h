#pragma once

#include <string>
#include <vector>

#include "core/series/history/device_history.h"
#include "core/series/history/history.h"

namespace alidade {

/// Formats numbers of one quantity, all with the same power of ten and as many decimals as show the smallest
/// U with two digits. Each ± is an expanded uncertainty at the history's coverage.
class HistoryNumbers {
 public:
  /// `unit`: may be empty.
  HistoryNumbers(const History& history, std::string unit);

  std::string number(double value) const;    ///< "1.308"
  std::string withUnit(double value) const;  ///< "1.308 mm", "6.6743 × 10⁻¹¹ m³"
  std::string exact(double value) const;     ///< "0.5 mm": a number that someone stated
  std::string withUncertainty(double value, double expanded) const;  ///< "1.308 mm ± 0.042 mm"
  std::string ratePerYear(double value, double expanded) const;      ///< "0.120 mm/a ± 0.040 mm/a"
  /// The power of ten by which a number is multiplied before it is shown.
  double scale() const;
  std::string heading() const;  ///< "mm", "10⁻¹¹ m³", or empty: heads a column of numbers

 private:
  int m_power = 0, m_decimals = 3;
  std::string m_unit;  ///< preceded by the power of ten

  std::string withUnit(double value, int decimals, const std::string& suffix) const;
};

/// "expanded uncertainty, 95 %": the meaning of each ± of a history.
std::string plusMinusText(const History& history);

/// The history in sentences: mean, χ², the course of the quantity, the probabilities of the courses, and
/// whether the values after the baseline are within their limits.
std::vector<std::string> historySentences(const History& history, const std::string& unit);

/// States which errors the sessions of a device share. Comparisons between sessions exclude these.
std::string sharedSentence(const DeviceHistory& device);

/// States whether Δd, the rest of the device and the set-up have changed between two epochs.
std::vector<std::string> congruenceSentences(const std::vector<Epoch>& epochs, const Congruence& congruence);

/// The name of a quantity for people, by its id: "Δd, measured", "O1, x", "trunnion tilt: tilt".
std::string quantityName(const std::string& id);

/// The name of a course for people: "constant", "in steps".
std::string courseName(Course course);

/// States that the session `title` is not used because it has no date.
std::string undatedSentence(const std::string& title);

}  // namespace alidade
