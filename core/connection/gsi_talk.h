#pragma once

#include "core/base/result.h"
#include "core/connection/talk.h"

namespace alidade {

// GSI online: the key REC of the instrument sends a block of words (core/exchange/gsi_word.h). The instrument
// repeats the block unless `?` acknowledges it. An equal block within `repeatWithin` is therefore the same
// sighting: two sightings differ in the point number, which instruments increment, or in their last digits. A
// reading can also be requested by `GET/M/WI21/WI22`, whose answer is not acknowledged. The serial number is
// requested once the port is open (`GET/I/WI12`) and stays empty without an answer. `@W…` and `@E…` are
// warnings and errors. The words do not state the kind of vertical circle: that of the session is assumed.
// Sources: GSI ONLINE for Leica TPS and DNA (Leica Geosystems, 2008); for words, the TPS1100 manual. The time
// before a block is repeated, and whether answers need an acknowledgement, depend on the instrument.

class GsiTalk : public InstrumentTalk {
 public:
  explicit GsiTalk(const TalkCircles& circles, const TalkTimes& times = {})
      : InstrumentTalk(circles, times) {}

  bool isTaking() const override { return m_readingUntil.has_value(); }

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

  std::optional<Milliseconds> m_readingUntil = {};  ///< time limit of a requested reading
  std::optional<Milliseconds> m_serialUntil = {};   ///< time limit of the requested serial number
  std::string m_lastBlock;                          ///< last block taken
  Milliseconds m_lastAt = 0;                        ///< time when `m_lastBlock` last arrived
};

/// The reading of a block, or a sentence on its problem.
Result<InstrumentReading> gsiReading(const std::string& block, VerticalCircle circle);

}  // namespace alidade
