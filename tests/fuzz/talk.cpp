#include "core/base/angle_text.h"
#include "core/connection/geocom_talk.h"
#include "core/connection/gsi_talk.h"
#include "core/connection/simulated_instrument.h"
#include "core/session/face.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/steering.h"
#include "tests/fuzz/targets.h"

namespace alidade::fuzz {

namespace {

constexpr VerticalCircle circles[] = {VerticalCircle::Zenith, VerticalCircle::Elevation};
constexpr CircleUnit units[] = {CircleUnit::Dms, CircleUnit::Degrees, CircleUnit::Gon};

/// The results of a step are valid for a session, with at most as many readings as lines.
void look(const TalkStep& step, VerticalCircle circle) {
  std::size_t received = 0;
  for (const TalkLine& line : step.lines) {
    received += line.isSent ? 0 : 1;
    require(line.text.size() <= LineAssembler::longest, "a line grew");
  }
  require(step.readings.size() <= received, "a reading out of nothing");
  for (const InstrumentReading& reading : step.readings) {
    const Result<Angle> horizontal = parseAngle(reading.horizontal), vertical = parseAngle(reading.vertical);
    require(horizontal && vertical, "a reading that is no angle");
    require(horizontal->degrees() >= 0 && horizontal->degrees() < 360, "outside of the circle");
    require(reading.face == (isFaceTwo(*vertical, circle) ? 2 : 1), "another face than the circle's");
  }
}

/// Starts, requests readings and ticks occasionally; the bytes determine the pieces in which they arrive.
template <class Talk>
void throwAt(std::string_view bytes, const TalkCircles& settings) {
  Talk talk(settings);
  Steering steering(bytes);
  Milliseconds now = 0;
  look(talk.begin(now), settings.vertical);
  while (!bytes.empty()) {
    const std::size_t length = std::min(bytes.size(), 1 + steering.below(64));
    look(talk.receive(bytes.substr(0, length), now), settings.vertical);
    bytes.remove_prefix(length);
    now += static_cast<Milliseconds>(steering.below(4)) * 700;
    if (steering.below(3) == 0) look(talk.take(now), settings.vertical);
    if (steering.below(2) == 0) look(talk.tick(now), settings.vertical);
  }
  for (int turn = 0; turn < 1000 && talk.wakeAt(); ++turn)
    look(talk.tick(now = *talk.wakeAt()), settings.vertical);
  require(!talk.wakeAt() && !talk.isTaking(), "it waits for ever");
}

}  // namespace

void throwTalk(std::string_view bytes) {
  for (const VerticalCircle circle : circles) {
    for (const CircleUnit unit : units) throwAt<GeoComTalk>(bytes, {circle, unit});
    throwAt<GsiTalk>(bytes, {circle, CircleUnit::Dms});
  }
  for (const InstrumentProtocol protocol : {InstrumentProtocol::GeoCom, InstrumentProtocol::Gsi}) {
    SimulatedOptions options;
    options.protocol = protocol;
    options.sightings.resize(2);
    SimulatedInstrument instrument(options);
    instrument.record(0);
    instrument.receive(bytes);
    require(instrument.delivered() <= options.sightings.size(), "told more than there is");
  }
}

}  // namespace alidade::fuzz
