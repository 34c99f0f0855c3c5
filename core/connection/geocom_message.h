#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alidade {

// GeoCOM, the question and answer protocol of Leica's instruments, as lines:
//
//   %R1Q,<rpc>[,<transaction>[,<crc>]]:<parameters>
//   %R1P,<communication code>,<transaction>[,<crc>]:<return code>[,<parameters>]
//
// Parameters are separated by commas; texts are in double quotes; angles are radians. An answer repeats the
// transaction number of its question, 0 to 7. The check sum, a decimal number, is CRC-16/ARC of the line
// without the check sum and the comma before it. Instruments send check sums only if they are set to do so.
// Sources: GeoCOM Reference Manual, TPS1200 (Leica Geosystems), and the MIT-licensed GeoComPy
// (geo/__init__.py, geo/tmc.py, geo/com.py, geo/csv.py), which determined the check sum by experiment.

namespace geocom {
inline constexpr int null = 0, doublePrecision = 108, softwareVersion = 110, switchOn = 111, angles = 2003,
                     plainAngles = 2107, setCompensator = 2006, compensator = 2007, corrections = 2014,
                     face = 2026, instrumentNumber = 5003, instrumentName = 5004, temperature = 5011;
inline constexpr int done = 0, notImplemented = 5, systemBusy = 12, notAvailable = 27,
                     notFullyCorrected = 1283, accuracyUncertain = 1284, anglesOnly = 1285,
                     anglesNotFullyCorrected = 1288, anglesUncertain = 1289, busy = 1293, cannotSend = 3075,
                     timedOut = 3077;
inline constexpr int lastTransaction = 7;
}  // namespace geocom

struct GeoComQuestion {
  int rpc = 0;
  std::optional<int> transaction = {};
  std::vector<std::string> parameters = {};
};

struct GeoComAnswer {
  int communicationCode = 0;
  int transaction = 0;
  int returnCode = 0;
  std::vector<std::string> parameters = {};  ///< texts without their quotes
  bool isSound = true;                       ///< false: the check sum is wrong
};

std::string geoComLine(const GeoComQuestion& question);
std::string geoComLine(const GeoComAnswer& answer);

/// Absent if the line is not a question.
std::optional<GeoComQuestion> geoComQuestion(std::string_view line);
/// Skips noise before `%R1P`, as from a cable just plugged in. Absent if the line is not an answer.
std::optional<GeoComAnswer> geoComAnswer(std::string_view line);

/// CRC-16/ARC: polynomial x¹⁶ + x¹⁵ + x² + 1, reflected, initial value 0; for "123456789" it is 0xBB3D.
int geoComChecksum(std::string_view text);

/// Are the angles of an answer with this return code usable?
bool hasAngles(int returnCode);
/// Does this return code guarantee the angles? A missing distance does not matter.
bool isGuaranteed(int returnCode);
/// May the instrument answer the same question a moment later?
bool isBusy(int returnCode);

/// The meaning of a return code, as a sentence.
std::string geoComSentence(int returnCode);

}  // namespace alidade
