#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/angle_text.h"
#include "core/connection/instrument_reading.h"
#include "core/connection/line_assembler.h"
#include "core/session/measurement.h"

namespace alidade {

// The connection with an instrument as a state machine: inputs are bytes and the time, outputs are bytes to
// send, readings and sentences. It is independent of port, clock and window; their owner calls `receive` when
// bytes arrive and `tick` at `wakeAt`. For any sequence of bytes, readings are taken only once, and dropped
// data are reported.

/// The circles of the session: kind of vertical circle, and unit.
struct TalkCircles {
  VerticalCircle vertical = VerticalCircle::Zenith;
  CircleUnit unit = CircleUnit::Dms;  ///< unit in which angles sent in radians are written
};

struct TalkTimes {
  Milliseconds answerWithin = 5000;   ///< limit for angles: the compensator may need 3 s to come to rest
  Milliseconds wakeWithin = 1500;     ///< limit for the answer to any other question
  Milliseconds lineWithin = 2000;     ///< limit for the rest of a line: 300 bytes take 1.3 s at 2400 baud
  Milliseconds busyPause = 400;       ///< pause between a busy answer and the repeated question
  Milliseconds repeatWithin = 20000;  ///< the same block within this time is the same sighting
  int attempts = 3;                   ///< most attempts at an unanswered question
  int busyAttempts = 12;              ///< most repetitions of a question that is answered with busy
};

/// A line that was sent or received, for the log.
struct TalkLine {
  bool isSent = false;
  std::string text;  ///< without its end
};

/// The results of one call.
struct TalkStep {
  std::string toSend;
  std::vector<TalkLine> lines;              ///< lines in the order sent and received
  std::vector<InstrumentReading> readings;  ///< readings in the order taken
  std::vector<std::string> remarks;         ///< sentences for people
  bool isIdentified = false;                ///< the identity is now known
};

class InstrumentTalk {
 public:
  InstrumentTalk(const TalkCircles& circles, const TalkTimes& times)
      : m_circles(circles), m_times(times), m_lines(times.lineWithin) {}
  InstrumentTalk(const InstrumentTalk&) = delete;
  InstrumentTalk& operator=(const InstrumentTalk&) = delete;
  virtual ~InstrumentTalk() = default;

  void setCircles(const TalkCircles& circles) { m_circles = circles; }

  /// Starts the dialogue; call it when the port is open.
  TalkStep begin(Milliseconds now);
  TalkStep receive(std::string_view bytes, Milliseconds now);
  /// Requests a reading of the current target.
  TalkStep take(Milliseconds now);
  TalkStep tick(Milliseconds now);
  /// The next time `tick` is needed; absent: only after further bytes.
  std::optional<Milliseconds> wakeAt() const;

  /// Is a requested reading pending?
  virtual bool isTaking() const = 0;
  const InstrumentIdentity& identity() const { return m_identity; }

 protected:
  virtual void onBegin(Milliseconds now, TalkStep& step) = 0;
  virtual void onLine(const std::string& line, Milliseconds now, TalkStep& step) = 0;
  virtual void onTake(Milliseconds now, TalkStep& step) = 0;
  virtual void onTick(Milliseconds now, TalkStep& step) = 0;
  /// Called after an incomplete line was dropped: a pending answer in that line will not arrive.
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
