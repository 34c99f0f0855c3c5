#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/circle_unit.h"
#include "core/connection/instrument_reading.h"
#include "core/connection/line_assembler.h"
#include "core/session/measurement.h"

namespace alidade {

// A talk with an instrument as a machine of states: bytes and the time go in, bytes to send, readings and
// sentences come out. It knows no port, no clock and no window; who has these calls `receive` when bytes come
// and `tick` when `wakeAt` is reached. Whatever comes in whatever pieces, no reading is taken twice, and what
// is dropped is told.

/// How the circles of the session read.
struct TalkCircles {
  VerticalCircle vertical = VerticalCircle::Zenith;
  CircleUnit unit = CircleUnit::Dms;  ///< in which angles are written that the instrument tells in radians
};

struct TalkTimes {
  Milliseconds answerWithin = 5000;   ///< the compensator may take three seconds to come to rest
  Milliseconds wakeWithin = 1500;     ///< an answer to the first question
  Milliseconds lineWithin = 2000;     ///< the rest of a line: 300 characters take 1.3 s at 2400 baud
  Milliseconds busyPause = 400;       ///< before what was busy is asked again
  Milliseconds repeatWithin = 20000;  ///< the same block within this time is the same sighting
  int attempts = 3;                   ///< of a question that is not answered
  int busyAttempts = 12;              ///< of a question that is answered with busy
};

/// A line as it went over the wire, for the log.
struct TalkLine {
  bool isSent = false;
  std::string text;  ///< without its end
};

/// What came of one call.
struct TalkStep {
  std::string toSend;
  std::vector<TalkLine> lines;              ///< in their order
  std::vector<InstrumentReading> readings;  ///< in the order taken
  std::vector<std::string> remarks;         ///< sentences for people
  bool isIdentified = false;                ///< the identity is known from now on
};

class InstrumentTalk {
 public:
  InstrumentTalk(const TalkCircles& circles, const TalkTimes& times)
      : m_circles(circles), m_times(times), m_lines(times.lineWithin) {}
  InstrumentTalk(const InstrumentTalk&) = delete;
  InstrumentTalk& operator=(const InstrumentTalk&) = delete;
  virtual ~InstrumentTalk() = default;

  void setCircles(const TalkCircles& circles) { m_circles = circles; }

  /// The port is open.
  TalkStep begin(Milliseconds now);
  TalkStep receive(std::string_view bytes, Milliseconds now);
  /// A reading is wanted of what the telescope points at now.
  TalkStep take(Milliseconds now);
  TalkStep tick(Milliseconds now);
  /// When `tick` has something to do next; absent: not before something comes.
  std::optional<Milliseconds> wakeAt() const;

  /// A reading was wanted and is still to come.
  virtual bool isTaking() const = 0;
  const InstrumentIdentity& identity() const { return m_identity; }

 protected:
  virtual void onBegin(Milliseconds now, TalkStep& step) = 0;
  virtual void onLine(const std::string& line, Milliseconds now, TalkStep& step) = 0;
  virtual void onTake(Milliseconds now, TalkStep& step) = 0;
  virtual void onTick(Milliseconds now, TalkStep& step) = 0;
  /// Half a line was dropped: who waits for it waits in vain.
  virtual void onLineLost(Milliseconds, TalkStep&) {}
  virtual std::optional<Milliseconds> onWakeAt() const = 0;

  static void send(const std::string& line, TalkStep& step);

  TalkCircles m_circles;
  TalkTimes m_times;
  InstrumentIdentity m_identity;

 private:
  LineAssembler m_lines;
};

}  // namespace alidade
