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

// A simulated instrument for testing a connection by GeoCOM or GSI online. It points at one target after the
// other and simulates typical faults. As with a real observer, the telescope stays until the sighting was
// delivered completely: a cut or lost sighting is sent again. Input and output are bytes and time.

/// A fault of one sighting, which occurs once; then the sighting is delivered.
enum class InstrumentFault {
  Garbage,        ///< noise before the line
  Cut,            ///< half a line, as from a pulled cable
  Silent,         ///< no answer, no block
  Twice,          ///< the line is sent twice
  Busy,           ///< busy at first
  Wrong,          ///< the telescope points elsewhere
  OtherFace,      ///< the same target in the other face
  Turned,         ///< the axis was turned too early: the same point in the other position
  Again,          ///< the sighting before the last one is sent again, long after its acknowledgement
  NotGuaranteed,  ///< not guaranteed: a GeoCOM return code, or a GSI word keyed in with the compensator off
  OtherSerial,    ///< another instrument is on the cable
  WrongChecksum,  ///< GeoCOM: the check sum of an answer is wrong
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
    InstrumentFaultName{"not-vouched-for", InstrumentFault::NotGuaranteed},
    InstrumentFaultName{"other-serial", InstrumentFault::OtherSerial},
    InstrumentFaultName{"wrong-checksum", InstrumentFault::WrongChecksum}};

enum class InstrumentProtocol { GeoCom, Gsi };

struct SimulatedOptions {
  InstrumentProtocol protocol = InstrumentProtocol::GeoCom;
  std::vector<SimulatedSighting> sightings = {};
  std::vector<InstrumentFault> faults = {};  ///< simulated in turn
  std::size_t faultEvery = 0;                ///< n: a fault occurs in every n-th sighting; 0: never
  bool isWide = true;                        ///< GSI-16, else GSI-8
  char gsiUnit = '4';                        ///< 2 gon, 3 decimal degrees, 4 degrees minutes seconds
  std::array<bool, 4> corrections = {true, true, true,
                                     true};  ///< inclination, standing axis, collimation, tilting
  bool isCompensated = true;
  bool hasChecksums = false;  ///< GeoCOM answers have check sums
  std::string name = "Alidade simulated instrument", serial = "1000001", otherSerial = "2000002";
};

class SimulatedInstrument {
 public:
  /// The time after which an unacknowledged block is sent again.
  static constexpr Milliseconds repeatAfter = 1000;

  explicit SimulatedInstrument(SimulatedOptions options)
      : m_options(std::move(options)), m_hadFault(m_options.sightings.size(), false) {}

  /// The response to these bytes.
  std::string receive(std::string_view bytes);
  /// The key REC, which with GSI sends a block; without effect while a block waits for its acknowledgement.
  std::string record(Milliseconds now);
  /// Repeats an unacknowledged block after `repeatAfter`.
  std::string tick(Milliseconds now);

  /// The number of sightings delivered completely.
  std::size_t delivered() const { return m_at; }
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
  std::size_t m_faults = 0;  ///< number of simulated faults
  std::size_t m_codes = 0;   ///< number of answers without guarantee
  bool m_isOther = false;    ///< the next angles are those of another instrument
  std::string m_line;        ///< received characters of an incomplete line
  struct Waiting {
    std::string block;
    Milliseconds since;
    bool counts;    ///< its acknowledgement completes the sighting
    bool losesOne;  ///< loses one acknowledgement, so that the block is repeated
  };
  std::optional<Waiting> m_waiting;  ///< the block that is not yet acknowledged
};

}  // namespace alidade
