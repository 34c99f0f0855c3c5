#include "core/connection/simulated_instrument.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/number_text.h"

namespace alidade {

namespace {

constexpr int radiansDecimals = 15;
constexpr std::size_t longestLine = 1000;
constexpr const char* lineEnd = "\r\n";
constexpr const char* noise = "\x01\xf3~0{\r";
constexpr double wrongBy = 20;  // degrees: another target
constexpr double accuracyArcsec = 0.5;
constexpr std::array notGuaranteed = {geocom::notFullyCorrected, geocom::accuracyUncertain,
                                      geocom::anglesNotFullyCorrected, geocom::anglesUncertain};

/// Is the sighting delivered despite the fault, so that the telescope moves on?
bool isDelivered(std::optional<InstrumentFault> fault) {
  using enum InstrumentFault;
  return !fault || *fault == Garbage || *fault == Twice;
}

std::string radians(Angle angle) {
  return fixedText(angle.radians(), radiansDecimals);
}

std::string padded(long long number, std::size_t width) {
  const std::string digits = std::to_string(number);
  return std::string(width > digits.size() ? width - digits.size() : 0, '0') + digits;
}

/// The digits of a word: units of 10⁻⁵ gon or degrees, or DDDMMSSs with s in tenths of a second.
long long gsiNumber(Angle angle, char unit) {
  constexpr long long fullGon = 40'000'000, fullDegrees = 36'000'000, fullTenths = 12'960'000;
  if (unit == '2') return std::llround(angle.degrees() / 0.9 * 1e5) % fullGon;
  if (unit == '3') return std::llround(angle.degrees() * 1e5) % fullDegrees;
  const long long tenths = std::llround(angle.arcseconds() * 10) % fullTenths;
  return tenths / 36000 * 100'000 + tenths / 600 % 60 * 1000 + tenths % 600;
}

std::string serialWordOf(const std::string& serial, bool isWide) {
  const std::size_t width = isWide ? 16 : 8;
  return "12....+" + std::string(width - std::min(width, serial.size()), '0') + serial + " ";
}

std::string withOtherChecksum(std::string line) {
  const std::size_t colon = line.find(':');
  if (std::count(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(colon), ',') == 2)
    return line.insert(colon, "," + std::to_string(geoComChecksum(line) ^ 1));
  const std::size_t comma = line.rfind(',', colon);
  const int sound = std::stoi(line.substr(comma + 1));
  return line.replace(comma + 1, colon - comma - 1, std::to_string(sound ^ 1));
}

}  // namespace

std::string SimulatedInstrument::receive(std::string_view bytes) {
  std::string sent;
  for (const char c : bytes) {
    if (c != '\r' && c != '\n') {
      if (m_line.size() < longestLine) m_line += c;
      continue;
    }
    if (!m_line.empty()) sent += answer(std::exchange(m_line, {}));
  }
  return sent;
}

std::string SimulatedInstrument::answer(const std::string& line) {
  if (m_options.protocol == InstrumentProtocol::GeoCom) {
    const auto question = geoComQuestion(line);
    return question ? answerGeoCom(*question) : std::string();
  }
  return answerGsi(line);
}

std::string SimulatedInstrument::answerGsi(const std::string& line) {
  if (line == "?") {
    if (!m_waiting) return {};
    if (std::exchange(m_waiting->losesOne, false)) return {};
    if (m_waiting->counts) ++m_at;
    m_waiting.reset();
    return {};
  }
  if (line == "GET/I/WI12")
    return (m_options.isWide ? "*" : "") + serialWordOf(m_options.serial, m_options.isWide) + lineEnd;
  if (line.starts_with("GET/") && line.find("WI21") != std::string::npos) {
    if (isDone() || m_waiting)
      return std::string("@W100") + lineEnd;  // busy: a block waits, or no sighting is left
    const auto fault = faultNow();
    if (fault == InstrumentFault::Busy) return std::string("@W100") + lineEnd;
    if (fault == InstrumentFault::Silent) return {};
    const std::string reply = block(fault, true);
    if (fault == InstrumentFault::Cut) return reply.substr(0, reply.size() / 2);
    if (isDelivered(fault)) ++m_at;
    return withFault(reply + lineEnd, fault);
  }
  const bool isSet = line.starts_with("SET/") || line.starts_with("PUT/") || line.starts_with("CONF/");
  return std::string(isSet ? "?" : "@W127") + lineEnd;
}

std::string SimulatedInstrument::record(Milliseconds now) {
  if (m_options.protocol != InstrumentProtocol::Gsi || m_waiting || isDone()) return {};
  const auto fault = faultNow();
  if (fault == InstrumentFault::Silent) return {};
  if (fault == InstrumentFault::Busy) return std::string("@W100") + lineEnd;
  const bool isDeliveredNow = isDelivered(fault) || fault == InstrumentFault::Cut;
  m_waiting = Waiting{block(fault, false) + lineEnd, now, isDeliveredNow, fault == InstrumentFault::Twice};
  if (fault == InstrumentFault::Cut) return m_waiting->block.substr(0, m_waiting->block.size() / 2);
  return withFault(m_waiting->block, fault == InstrumentFault::Twice ? std::nullopt : fault);
}

std::string SimulatedInstrument::tick(Milliseconds now) {
  if (!m_waiting || now < m_waiting->since + repeatAfter) return {};
  m_waiting->since = now;
  return m_waiting->block;
}

std::string SimulatedInstrument::answerGeoCom(const GeoComQuestion& question) {
  const auto give = [&](std::vector<std::string> parameters) {
    return geoComText(geocom::done, std::move(parameters), question) + lineEnd;
  };
  const auto flag = [](bool is) { return std::string(is ? "1" : "0"); };
  switch (question.rpc) {
    case geocom::null:
    case geocom::switchOn:
    case geocom::setCompensator:
      if (question.rpc == geocom::setCompensator && !question.parameters.empty())
        m_options.isCompensated = question.parameters[0] != "0";
      return give({});
    case geocom::doublePrecision:
      return give({std::to_string(radiansDecimals)});
    case geocom::softwareVersion:
      return give({"9", "10", "0"});
    case geocom::instrumentNumber:
      return give({serialNow()});
    case geocom::instrumentName:
      return give({"\"" + m_options.name + "\""});
    case geocom::temperature:
      return give({"24"});
    case geocom::compensator:
      return give({flag(m_options.isCompensated)});
    case geocom::corrections:
      return give({flag(m_options.corrections[0]), flag(m_options.corrections[1]),
                   flag(m_options.corrections[2]), flag(m_options.corrections[3])});
    case geocom::face:
      return give({flag(!isDone() && m_options.sightings[m_at].zenith.degrees() > 180)});
    case geocom::angles:
    case geocom::plainAngles:
      return answerAngles(question);
    default:
      return geoComText(geocom::notImplemented, {}, question) + lineEnd;
  }
}

std::string SimulatedInstrument::answerAngles(const GeoComQuestion& question) {
  if (isDone()) return geoComText(geocom::busy, {}, question) + lineEnd;
  const auto fault =
      std::exchange(m_isOther, false) ? std::optional(InstrumentFault::OtherSerial) : faultNow();
  if (fault == InstrumentFault::Busy) return geoComText(geocom::busy, {}, question) + lineEnd;
  if (fault == InstrumentFault::Silent) return {};
  const SimulatedSighting sighting = pointedAt(fault);
  std::vector<std::string> values = {radians(sighting.horizontal), radians(sighting.zenith)};
  if (question.rpc == geocom::angles) {
    const std::string accuracy = radians(Angle::fromArcseconds(accuracyArcsec));
    const bool isFaceTwo = sighting.zenith.degrees() > 180;
    for (const std::string& value : {accuracy, std::string("1000"), radians(sighting.tiltCross),
                                     radians(sighting.tiltLength), accuracy, std::string("1000")})
      values.push_back(value);
    values.emplace_back(isFaceTwo ? "1" : "0");
  }
  std::string line = geoComText(codeNow(fault), values, question);
  if (fault == InstrumentFault::Cut) return line.substr(0, line.size() / 2);
  if (fault == InstrumentFault::WrongChecksum) line = withOtherChecksum(line);
  if (isDelivered(fault)) ++m_at;
  return withFault(line + lineEnd, fault);
}

/// With the fault OtherSerial, the serial number and the reading that follows are of another instrument.
std::string SimulatedInstrument::serialNow() {
  m_isOther = faultDue() == InstrumentFault::OtherSerial;
  if (m_isOther) faultNow();
  return m_isOther ? m_options.otherSerial : m_options.serial;
}

int SimulatedInstrument::codeNow(std::optional<InstrumentFault> fault) {
  if (fault != InstrumentFault::NotGuaranteed) return geocom::done;
  return notGuaranteed.at(m_codes++ % notGuaranteed.size());
}

std::string SimulatedInstrument::geoComText(int returnCode, std::vector<std::string> parameters,
                                            const GeoComQuestion& question) const {
  std::string line =
      geoComLine(GeoComAnswer{0, question.transaction.value_or(0), returnCode, std::move(parameters)});
  if (m_options.hasChecksums) line.insert(line.find(':'), "," + std::to_string(geoComChecksum(line)));
  return line;
}

std::string SimulatedInstrument::block(std::optional<InstrumentFault> fault, bool isAnswer) const {
  const SimulatedSighting sighting = pointedAt(fault);
  const std::size_t width = m_options.isWide ? 16 : 8;
  const auto number = static_cast<long long>(pointedAtIndex(fault)) + 1;
  const std::string info =
      (fault == InstrumentFault::NotGuaranteed ? ".01" : ".32") + std::string(1, m_options.gsiUnit);
  std::string text = m_options.isWide ? "*" : "";
  if (!isAnswer) text += "11" + padded(number % 10000, 4) + "+" + padded(number, width) + " ";
  if (fault == InstrumentFault::OtherSerial) text += serialWordOf(m_options.otherSerial, m_options.isWide);
  text += "21" + info + "+" + padded(gsiNumber(sighting.horizontal, m_options.gsiUnit), width) + " ";
  return text + "22" + info + "+" + padded(gsiNumber(sighting.zenith, m_options.gsiUnit), width) + " ";
}

std::string SimulatedInstrument::withFault(const std::string& line, std::optional<InstrumentFault> fault) {
  if (fault == InstrumentFault::Garbage) return noise + line;
  return fault == InstrumentFault::Twice ? line + line : line;
}

/// The next fault, if one is due and this sighting had none.
std::optional<InstrumentFault> SimulatedInstrument::faultDue() const {
  if (m_options.faults.empty() || m_options.faultEvery == 0 || isDone()) return std::nullopt;
  if ((m_at + 1) % m_options.faultEvery != 0 || m_hadFault[m_at]) return std::nullopt;
  return m_options.faults[m_faults % m_options.faults.size()];
}

/// The due fault, which then counts as used.
std::optional<InstrumentFault> SimulatedInstrument::faultNow() {
  const auto fault = faultDue();
  if (fault) {
    m_hadFault[m_at] = true;
    ++m_faults;
  }
  return fault;
}

std::size_t SimulatedInstrument::pointedAtIndex(std::optional<InstrumentFault> fault) const {
  const std::size_t count = m_options.sightings.size();
  if (fault == InstrumentFault::Again) return m_at - std::min<std::size_t>(m_at, 2);
  return fault == InstrumentFault::Turned ? (m_at + count / 2) % count : m_at;
}

SimulatedSighting SimulatedInstrument::pointedAt(std::optional<InstrumentFault> fault) const {
  constexpr Angle half = Angle::fromDegrees(180);
  SimulatedSighting sighting = m_options.sightings[pointedAtIndex(fault)];
  if (fault == InstrumentFault::Wrong)
    sighting.horizontal = wrapped(sighting.horizontal + Angle::fromDegrees(wrongBy), half);
  if (fault == InstrumentFault::OtherFace) {
    sighting.horizontal = wrapped(sighting.horizontal + half, half);
    sighting.zenith = wrapped(-sighting.zenith, half);
  }
  return sighting;
}

}  // namespace alidade
