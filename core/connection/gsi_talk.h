#pragma once

#include "core/base/result.h"
#include "core/connection/talk.h"

namespace alidade {

// GSI online: the key REC of the instrument sends a block of words (core/exchange/gsi_word.h), which is
// acknowledged by `?`; where that stays out the instrument sends it again. The same block within a while is
// therefore the same sighting: instruments number their points on, and the last digits of two sightings
// differ. A reading can be asked for, too, by `GET/M/WI21/WI22`, whose answer needs no acknowledgement. Once
// the port is open the serial number is asked for (`GET/I/WI12`); who does not answer that has none. `@W…`
// and `@E…` are warnings and errors. The vertical circle is taken as the instrument is set to show it, which
// a word does not tell: as that of the session. Sources: GSI ONLINE for Leica TPS and DNA (Leica Geosystems,
// 2008), for words the TPS1100 manual; when a block is sent again, and that an answer is not acknowledged,
// hangs on the instrument.

class GsiTalk : public InstrumentTalk {
 public:
  explicit GsiTalk(const TalkCircles& circles, const TalkTimes& times = {})
      : InstrumentTalk(circles, times) {}

  bool isTaking() const override { return m_askedUntil.has_value(); }

 protected:
  void onBegin(Milliseconds now, TalkStep& step) override;
  void onLine(const std::string& line, Milliseconds now, TalkStep& step) override;
  void onTake(Milliseconds now, TalkStep& step) override;
  void onTick(Milliseconds now, TalkStep& step) override;
  std::optional<Milliseconds> onWakeAt() const override;

 private:
  void takeBlock(const std::string& line, Milliseconds now, TalkStep& step);
  void takeCode(const std::string& code, TalkStep& step);
  bool takeSerial(const std::string& line, TalkStep& step);
  bool wasTaken(const std::string& line, Milliseconds now) const;

  std::optional<Milliseconds> m_askedUntil = {};   ///< of a reading that was asked for
  std::optional<Milliseconds> m_serialUntil = {};  ///< of the serial number that was asked for
  std::string m_lastBlock;                         ///< taken last
  Milliseconds m_lastAt = 0;                       ///< when it came, or came again
};

/// The reading of a block; what is wrong with it otherwise, as a sentence.
Result<InstrumentReading> gsiReading(const std::string& block, VerticalCircle circle);

}  // namespace alidade
