#pragma once

#include <cstddef>
#include <deque>
#include <set>

#include "core/connection/geocom_message.h"
#include "core/connection/talk.h"

namespace alidade {

// The program's side of a GeoCOM connection. It first asks two empty questions, since the first may be lost
// while the instrument wakes, then for the number of decimals, the identity and the temperature. For each
// reading it asks for serial number, corrections and compensator state (RPC 5003, 2014, 2007), which may have
// changed, then for circles and tilts (2003). Only one question is pending. After a busy, damaged or missing
// answer it is repeated with a new transaction number. Answers with an outdated number are dropped.

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

  std::deque<Question> m_questions;          ///< the first is pending, or waits for `m_askAt`
  std::optional<int> m_waitsFor;             ///< transaction number of the pending question; absent: none
  Milliseconds m_deadline = 0;               ///< latest time of the pending answer
  std::optional<Milliseconds> m_askAt = {};  ///< time to repeat the first question; absent: no pause
  int m_transaction = 0;
  bool m_isAwake = false, m_isTaking = false, m_isIdentified = false;
  std::set<int> m_notAnswered;  ///< RPCs that this instrument refused
  bool m_hasAngles = false;
  bool m_wasSpoiled = false;                 ///< the last answer to the pending question was damaged
  std::optional<bool> m_isCompensated = {};  ///< the compensator is on; absent: unknown
  InstrumentReading m_reading;               ///< valid if `m_hasAngles`
};

}  // namespace alidade
