#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "core/base/angle_text.h"
#include "core/connection/instrument_reading.h"
#include "core/session/face.h"
#include "core/session/session.h"
#include "tests/ui/support.h"
#include "ui/connection/instrument_desk.h"
#include "ui/connection/reading_flow.h"
#include "ui/main_window.h"

namespace alidade::ui {

inline InstrumentReading readingOf(const std::string& horizontal, const std::string& vertical) {
  InstrumentReading reading;
  reading.horizontal = horizontal;
  reading.vertical = vertical;
  reading.horizontalAngle = *parseAngle(horizontal);
  reading.verticalAngle = *parseAngle(vertical);
  reading.face = isFaceTwo(reading.verticalAngle, VerticalCircle::Zenith) ? 2 : 1;
  return reading;
}

inline InstrumentReading readingOf(const Reading& row) {
  return readingOf(row.horizontal, row.vertical);
}

inline InstrumentReading firstZero(const Session& session, std::size_t position) {
  const PointingZero& zero = session.positions[position].zero;
  return readingOf(zero.horizontal, zero.vertical);
}

/// A window whose reading flow receives readings without a connection.
struct LandingWindow {
  OpenWindow open;

  explicit LandingWindow(const Session& session) {
    open->document().startWith(session);
    open.waitUntilIdle();
  }
  /// Selects a tab as a user would, since an opened session starts with its first missing entry.
  void putInFront(std::size_t position) {
    flow().setFront([position] { return ReadingFlow::Front{position, {}}; });
  }
  ReadingFlow& flow() { return open->instrumentDesk().flow(); }
  const Session& session() { return open->document().session(); }
  std::string question() { return flow().question().toStdString(); }

  /// The question about the reading; empty: it was stored.
  std::string add(const InstrumentReading& reading) {
    flow().add(reading);
    EXPECT_TRUE(waitFor([&] { return flow().waiting() == 0 || !flow().question().isEmpty(); }));
    return question();
  }
  void take() {
    flow().takeAnyway();
    EXPECT_TRUE(waitFor([&] { return flow().waiting() == 0; }));
  }
};

}  // namespace alidade::ui
