#pragma once

#include <QString>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "core/connection/instrument_reading.h"
#include "ui/connection/reading_landing.h"

namespace alidade::ui {

/// Earlier readings over the connection with their data, for comparison with a new reading.
class TakenBefore {
 public:
  /// Only this many of the last readings are stored; an instrument buffers fewer.
  static constexpr std::size_t mostKept = 16;

  void add(const InstrumentReading& reading, std::size_t position);

  std::optional<std::size_t> position() const { return m_position; }  ///< position of the last reading
  const std::string& serial() const { return m_serial; }  ///< last serial number stated; empty: none
  const std::string& corrections() const { return m_corrections; }  ///< last corrections stated; empty: none
  std::optional<bool> isCompensated() const { return m_isCompensated; }
  const std::deque<InstrumentReading>& readings() const { return m_readings; }

 private:
  std::optional<std::size_t> m_position;
  std::string m_serial, m_corrections;
  std::optional<bool> m_isCompensated;
  std::deque<InstrumentReading> m_readings;
};

/// Objections to a reading, after a sentence that names its entry and its values; empty if there are none.
/// The function objects to an axis that was not turned, another instrument, a reading that the instrument
/// does not guarantee, new corrections, a repeated reading, the other face, a typed entry and another target.
QString readingQuestion(const Evaluation& evaluation, const Landing& landing,
                        const InstrumentReading& reading, const TakenBefore& before);

/// The question about a reading for which no entry is expected.
QString placelessQuestion(const Evaluation& evaluation, const InstrumentReading& reading);

}  // namespace alidade::ui
