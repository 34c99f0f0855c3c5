#pragma once

#include <cstddef>
#include <deque>
#include <set>

#include "core/connection/geocom_message.h"
#include "core/connection/talk.h"

namespace alidade {

// The program asks: twice nothing, since the first may be lost while the instrument wakes, then how fine its
// numbers are and what it is; for a reading both circles with the tilts of the compensator (RPC 2003), and
// before them which instrument it is, what it corrects and whether the compensator is on (5003, 2014, 2007):
// all of it may have been changed between two readings. One question at a time; what
// is answered with busy is asked again a little later, what is not answered is asked again with another
// number, and an answer that comes late or twice has a number that nobody waits for.

class GeoComTalk : public InstrumentTalk {
 public:
  explicit GeoComTalk(const TalkCircles& circles, const TalkTimes& times = {})
      : InstrumentTalk(circles, times) {}

  bool isTaking() const override { return m_isTaking; }

 protected:
  void onBegin(Milliseconds now, TalkStep& step) override;
  void onLine(const std::string& line, Milliseconds now, TalkStep& step) override;
  void onTake(Milliseconds now, TalkStep& step) override;
  void onTick(Milliseconds now, TalkStep& step) override;
  void onLineLost(Milliseconds now, TalkStep& step) override {
    if (m_waitsFor) askAgain(now, step);
  }
  std::optional<Milliseconds> onWakeAt() const override;

 private:
  enum class Need { Wakes, Angles, Optional };
  struct Question {
    int rpc = 0;
    Need need = Need::Optional;
    int attempts = 0, busy = 0;
  };

  void ask(Milliseconds now, TalkStep& step);
  void askAgain(Milliseconds now, TalkStep& step);
  void askAgainAsSpoiled(const std::string& remark, Milliseconds now, TalkStep& step);
  void next(Milliseconds now, TalkStep& step);
  void use(const GeoComAnswer& answer, Milliseconds now, TalkStep& step);
  bool takeAngles(const GeoComAnswer& answer, TalkStep& step);
  void takeIdentity(int rpc, const GeoComAnswer& answer);
  void takeSerial(const std::string& serial);
  void giveUp(std::optional<int> code, Milliseconds now, TalkStep& step);
  void finishReading(TalkStep& step);
  static bool isWhole(int rpc, const GeoComAnswer& answer);

  std::deque<Question> m_questions;          ///< the first of them is asked, or waits for `m_askAt`
  std::optional<int> m_waitsFor;             ///< transaction that was asked; absent: none
  Milliseconds m_deadline = 0;               ///< of its answer
  std::optional<Milliseconds> m_askAt = {};  ///< after a pause
  int m_transaction = 0;
  bool m_isAwake = false, m_isTaking = false, m_isIdentified = false;
  std::set<int> m_notAnswered;  ///< questions that this instrument has no answer to
  bool m_hasAngles = false;
  bool m_wasSpoiled = false;                 ///< the last answer to the first question
  std::optional<bool> m_isCompensated = {};  ///< the compensator is on; absent: not told
  InstrumentReading m_reading;               ///< of which `m_hasAngles` tells
};

}  // namespace alidade
