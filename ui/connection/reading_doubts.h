#pragma once

#include <QString>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "core/connection/instrument_reading.h"
#include "ui/connection/reading_landing.h"

namespace alidade::ui {

/// Earlier readings over the connection, as far as needed to compare a new one.
class TakenBefore {
 public:
  /// The last readings, more than an instrument buffers.
  static constexpr std::size_t mostKept = 16;

  void add(const InstrumentReading& reading, std::size_t position);

  std::optional<std::size_t> position() const { return m_position; }  ///< position of the last reading
  const std::string& serial() const { return m_serial; }  ///< serial number of the last reading; empty: none
  const std::string& corrections() const { return m_corrections; }  ///< of the last reading; empty: none
  std::optional<bool> isCompensated() const { return m_isCompensated; }
  const std::deque<InstrumentReading>& readings() const { return m_readings; }

 private:
  std::optional<std::size_t> m_position;
  std::string m_serial, m_corrections;
  std::optional<bool> m_isCompensated;
  std::deque<InstrumentReading> m_readings;
};

/// Objections to a reading, after a sentence with its target and its values: axis not turned, another
/// instrument, not guaranteed by the instrument, other corrections, repeated reading, other face, existing
/// entry, another target. Empty: none.
QString readingQuestion(const Evaluation& evaluation, const Landing& landing,
                        const InstrumentReading& reading, const TakenBefore& before);

/// The question about a reading without a target.
QString placelessQuestion(const Evaluation& evaluation, const InstrumentReading& reading);

}  // namespace alidade::ui
