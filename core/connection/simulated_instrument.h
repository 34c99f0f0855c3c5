#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/connection/geocom_message.h"
#include "core/connection/line_assembler.h"
#include "core/connection/simulated_sightings.h"

namespace alidade {

// An instrument to try a connection with: it speaks GeoCOM and GSI online, points at one sighting after the
// other, and does what goes wrong at a bench. As with one that a person points, the telescope stays where it
// is until the sighting was told whole: what was cut or lost is told again. Bytes and time in, bytes out.

/// What goes wrong with one sighting, once; then it is told.
enum class InstrumentFault {
  Garbage,        ///< noise before the line
  Cut,            ///< half a line, as of a cable that is pulled
  Silent,         ///< no answer, no block
  Twice,          ///< the line comes a second time
  Busy,           ///< busy at first
  Wrong,          ///< the telescope points elsewhere
  OtherFace,      ///< at the same target in the other face
  Turned,         ///< the axis was turned too early: the same place in the other position
  Again,          ///< the sighting before the last one a second time, long after it was acknowledged
  NotVouchedFor,  ///< GeoCOM: with a return code that says so; GSI: keyed in, the compensator off
  OtherSerial,    ///< another instrument is at the cable
  WrongChecksum,  ///< GeoCOM: of an answer
};

struct InstrumentFaultName {
  const char* name;
  InstrumentFault fault;
};
inline constexpr std::array instrumentFaults = {
    InstrumentFaultName{"garbage", InstrumentFault::Garbage},
    InstrumentFaultName{"cut", InstrumentFault::Cut},
    InstrumentFaultName{"silent", InstrumentFault::Silent},
    InstrumentFaultName{"twice", InstrumentFault::Twice},
    InstrumentFaultName{"busy", InstrumentFault::Busy},
    InstrumentFaultName{"wrong", InstrumentFault::Wrong},
    InstrumentFaultName{"other-face", InstrumentFault::OtherFace},
    InstrumentFaultName{"turned", InstrumentFault::Turned},
    InstrumentFaultName{"again", InstrumentFault::Again},
    InstrumentFaultName{"not-vouched-for", InstrumentFault::NotVouchedFor},
    InstrumentFaultName{"other-serial", InstrumentFault::OtherSerial},
    InstrumentFaultName{"wrong-checksum", InstrumentFault::WrongChecksum}};

enum class InstrumentProtocol { GeoCom, Gsi };

struct SimulatedOptions {
  InstrumentProtocol protocol = InstrumentProtocol::GeoCom;
  std::vector<SimulatedSighting> sightings = {};
  std::vector<InstrumentFault> faults = {};  ///< in turn
  std::size_t faultEvery = 0;                ///< so many sightings; 0: never
  bool isWide = true;                        ///< GSI-16, else GSI-8
  char gsiUnit = '4';                        ///< 2 gon, 3 decimal degrees, 4 degrees minutes seconds
  std::array<bool, 4> corrections = {true, true, true,
                                     true};  ///< inclination, standing axis, collimation, tilting
  bool isCompensated = true;
  bool hasChecksums = false;  ///< of answers of GeoCOM
  std::string name = "Alidade simulated instrument", serial = "1000001", otherSerial = "2000002";
};

class SimulatedInstrument {
 public:
  /// How long an unacknowledged block waits before it is sent again.
  static constexpr Milliseconds repeatAfter = 1000;

  explicit SimulatedInstrument(SimulatedOptions options)
      : m_options(std::move(options)), m_hadFault(m_options.sightings.size(), false) {}

  /// What it sends when these bytes come.
  std::string receive(std::string_view bytes);
  /// The key REC, which with GSI sends a block; nothing while one waits for its acknowledgement.
  std::string record(Milliseconds now);
  /// Sends again what was not acknowledged, and what it was busy with.
  std::string tick(Milliseconds now);

  /// How many sightings were told whole.
  std::size_t told() const { return m_at; }
  bool isDone() const { return m_at >= m_options.sightings.size(); }
  bool isWaiting() const { return m_waiting.has_value(); }

 private:
  std::string answer(const std::string& line);
  std::string answerGeoCom(const GeoComQuestion& question);
  std::string answerAngles(const GeoComQuestion& question);
  std::string answerGsi(const std::string& line);
  std::string serialNow();
  int codeNow(std::optional<InstrumentFault> fault);
  std::string geoComText(int returnCode, std::vector<std::string> parameters,
                         const GeoComQuestion& question) const;
  std::string block(std::optional<InstrumentFault> fault, bool isAnswer) const;
  std::string withFault(const std::string& line, std::optional<InstrumentFault> fault);
  std::optional<InstrumentFault> faultDue() const;
  std::optional<InstrumentFault> faultNow();
  std::size_t pointedAtIndex(std::optional<InstrumentFault> fault) const;
  SimulatedSighting pointedAt(std::optional<InstrumentFault> fault) const;

  SimulatedOptions m_options;
  std::vector<bool> m_hadFault;
  std::size_t m_at = 0;
  std::size_t m_faults = 0;  ///< so many were put in
  std::size_t m_codes = 0;   ///< so many answers were not vouched for
  bool m_isOther = false;    ///< the answer to come is that of another instrument
  std::string m_line;        ///< without its end
  struct Waiting {
    std::string block;
    Milliseconds since;
    bool counts;    ///< with its acknowledgement the sighting is told
    bool losesOne;  ///< acknowledgement, which then comes again
  };
  std::optional<Waiting> m_waiting;  ///< for its acknowledgement
};

}  // namespace alidade
