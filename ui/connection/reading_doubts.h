#pragma once

#include <QString>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "core/connection/instrument_reading.h"
#include "ui/connection/reading_landing.h"

namespace alidade::ui {

/// What was taken before over the cable, as far as a reading is held against it.
class TakenBefore {
 public:
  /// The last ones, more than an instrument holds in its buffer.
  static constexpr std::size_t mostKept = 16;

  void add(const InstrumentReading& reading, std::size_t position);

  std::optional<std::size_t> position() const { return m_position; }  ///< of the last one
  const std::string& serial() const { return m_serial; }              ///< that was taken last; empty: none
  const std::string& corrections() const { return m_corrections; }    ///< likewise
  std::optional<bool> isCompensated() const { return m_isCompensated; }
  const std::deque<InstrumentReading>& readings() const { return m_readings; }

 private:
  std::optional<std::size_t> m_position;
  std::string m_serial, m_corrections;
  std::optional<bool> m_isCompensated;
  std::deque<InstrumentReading> m_readings;
};

/// What speaks against a reading, sentence by sentence, after one that says where it would go and what was
/// read: the axis was to be turned for it, another instrument, one that does not vouch for it, other
/// corrections, a reading that came already, another face, something that stands there, another target.
/// Empty: nothing.
QString readingQuestion(const Evaluation& evaluation, const Landing& landing,
                        const InstrumentReading& reading, const TakenBefore& before);

/// Of a reading for which no place is asked.
QString placelessQuestion(const Evaluation& evaluation, const InstrumentReading& reading);

}  // namespace alidade::ui
