#pragma once

#include <string>
#include <vector>

#include "core/connection/simulated_instrument.h"
#include "core/connection/talk.h"

namespace alidade {

/// A connection and its results so far, with a manual clock.
struct TalkBench {
  InstrumentTalk& talk;
  Milliseconds now = 0;
  std::string sent = {};
  std::vector<InstrumentReading> readings = {};
  std::vector<std::string> remarks = {};

  void keep(const TalkStep& step) {
    sent += step.toSend;
    readings.insert(readings.end(), step.readings.begin(), step.readings.end());
    remarks.insert(remarks.end(), step.remarks.begin(), step.remarks.end());
  }
  void receive(const std::string& bytes) { keep(talk.receive(bytes, now)); }
  void wait(Milliseconds time) {
    now += time;
    keep(talk.tick(now));
  }
  /// The bytes sent since the last call.
  std::string takeSent() { return std::exchange(sent, {}); }
  bool said(const std::string& part) const {
    for (const std::string& remark : remarks)
      if (remark.find(part) != std::string::npos) return true;
    return false;
  }
};

/// Runs both sides until neither sends anything more at this time.
inline void exchange(TalkBench& bench, SimulatedInstrument& instrument) {
  for (std::string said = bench.takeSent(); !said.empty(); said = bench.takeSent())
    bench.receive(instrument.receive(said));
}

/// `count` places in both faces, with a resolution of a tenth of a second, all different.
inline std::vector<SimulatedSighting> twoFaceSightings(int count) {
  std::vector<SimulatedSighting> sightings;
  for (int i = 0; i < count; ++i) {
    const Angle horizontal = Angle::fromArcseconds(36000.0 + i * 4211.3),
                zenith = Angle::fromArcseconds(311000.0 + i * 701.7);
    const Angle tilt = Angle::fromArcseconds(i % 7 - 3);
    sightings.push_back({horizontal, zenith, tilt, -tilt});
    sightings.push_back(
        {horizontal + Angle::fromDegrees(180), Angle::fromDegrees(360) - zenith, -tilt, tilt});
  }
  return sightings;
}

}  // namespace alidade
