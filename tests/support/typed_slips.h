#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/base/angle_text.h"
#include "core/simulation/simulate.h"

namespace alidade::test {

// Simulated sessions with one typing slip of known kind, and whether the suspects found are right.
// Independent of the program's own list of slips.

enum class TypedError {
  None,
  DigitsSwapped,
  DigitWrong,
  DegreeOff,
  TenMinutesOff,
  MinuteOff,
  TenSecondsOff,
  CirclesSwapped,
  WrongFace,
  NeighbouringRow,  ///< one circle's readings of two consecutive rows exchanged
};

inline constexpr int errorKinds = 9;

struct MistypedSession {
  Session session;
  std::vector<CellChange> cure;  ///< the cells at fault, with the correct texts
  double visibleSigma = 0;       ///< largest |error| · √redundancy / σ; infinite if a text is unusable
};

inline std::string& cell(Session& session, const Place& where) {
  Reading& reading = session.positions[*where.position].readings[*where.reading];
  if (where.field == "face") return reading.face;
  if (where.field == "slider") return reading.slider;
  return where.field == "horizontal" ? reading.horizontal : reading.vertical;
}

inline std::string typedWrongly(const std::string& text, TypedError error, std::mt19937_64& random) {
  const auto pick = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  std::vector<std::size_t> digits;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] >= '0' && text[i] <= '9') digits.push_back(i);
  std::string wrong = text;
  if (error == TypedError::DigitsSwapped) {
    const std::size_t at = pick(digits.size() - 1);
    std::swap(wrong[digits[at]], wrong[digits[at + 1]]);
    return wrong;
  }
  if (error == TypedError::DigitWrong) {
    wrong[digits[pick(digits.size())]] = static_cast<char>('0' + pick(10));
    return wrong;
  }
  const double seconds = error == TypedError::DegreeOff       ? 3600
                         : error == TypedError::TenMinutesOff ? 600
                         : error == TypedError::MinuteOff     ? 60
                                                              : 10;
  const double sign = pick(2) == 0 ? 1 : -1;
  const Angle intended = *parseAngle(text);
  const int decimals = text.find('.') == std::string::npos ? 0 : 1;
  return formatDms(wrapped(intended + Angle::fromArcseconds(sign * seconds), Angle::fromDegrees(180)),
                   decimals, AngleSigns::Typewriter);
}

/// How far the slip shows in the fit of the clean session, in σ; infinite if a text is unusable.
inline double visibleSigma(const MistypedSession& mistyped, const JointFit& fit,
                           const Measurement& measurement) {
  double most = 0;
  for (const CellChange& change : mistyped.cure) {
    Session copy = mistyped.session;
    const auto wrong = parseAngle(cell(copy, change.where)), right = parseAngle(change.text);
    if (change.where.field == "face" || !wrong) return std::numeric_limits<double>::infinity();
    for (const AdjustedReading& reading : fit.readings) {
      const ArcMeasurement& arc = measurement.arcs[reading.arc];
      const char* field = reading.kind == ReadingKind::Horizontal ? "horizontal"
                          : reading.kind == ReadingKind::Vertical ? "vertical"
                                                                  : "slider";
      if (arc.position != change.where.position ||
          arc.sightings[reading.sighting].row != change.where.reading || change.where.field != field)
        continue;
      const double error = wrapped(*wrong - *right).radians();
      most = std::max(most, std::abs(error) * std::sqrt(reading.redundancy) / reading.sigma);
    }
  }
  return most;
}

/// A session by the protocol whose slip is visible by more than ten sigma; the truth, place and slip follow
/// from the seed. Kinds that are impossible in the protocol, or have no effect by chance, are drawn again.
inline MistypedSession mistypedSession(const Protocol& protocol, TypedError error, std::uint64_t seed,
                                       double step = 0.1) {
  std::mt19937_64 random(seed * 7919 + static_cast<std::uint64_t>(error));
  Truth truth = drawTruth(seed);
  truth.typingStep = Angle::fromArcseconds(step);
  // Ten seconds are five sigma of a 2″ instrument: they need a better one to be visible.
  if (error == TypedError::TenSecondsOff)
    truth.sigmaHorizontal = truth.sigmaVertical = Angle::fromArcseconds(0.5);
  const Session clean = *simulate(protocol, truth, seed);
  const Measurement measurement = *examine(clean).measurement;
  const JointFit fit = fitSession(measurement).joint;
  MistypedSession result{clean, {}, 0};
  if (error == TypedError::None) return result;
  for (int attempt = 0; attempt < 5000; ++attempt) {
    const auto pick = [&](std::size_t count) {
      return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
    };
    const std::size_t position = pick(clean.positions.size());
    const auto& readings = clean.positions[position].readings;
    const std::size_t row = pick(readings.size());
    const std::size_t column =
        pick(readings[row].slider.empty() || error == TypedError::NeighbouringRow ? 2 : 3);
    const Place where{.position = position,
                      .reading = row,
                      .field = column == 0   ? "horizontal"
                               : column == 1 ? "vertical"
                                             : "slider"};
    Session session = clean;
    result = {clean, {}, 0};
    const auto type = [&](const Place& place, const std::string& text) {
      result.cure.push_back({place, cell(session, place)});
      cell(result.session, place) = text;
    };
    if (error == TypedError::CirclesSwapped) {
      type({.position = position, .reading = row, .field = "horizontal"}, readings[row].vertical);
      type({.position = position, .reading = row, .field = "vertical"}, readings[row].horizontal);
    } else if (error == TypedError::WrongFace) {
      const std::string face = readings[row].face.empty() ? "1" : readings[row].face;
      type({.position = position, .reading = row, .field = "face"}, face == "1" ? "2" : "1");
    } else if (error == TypedError::NeighbouringRow) {
      if (row + 1 >= readings.size()) continue;
      Place next = where;
      next.reading = row + 1;
      const std::string own = cell(session, where), other = cell(session, next);
      type(where, other);
      type(next, own);
    } else {
      const std::string wrong = typedWrongly(cell(session, where), error, random);
      if (wrong == cell(session, where)) continue;
      type(where, wrong);
    }
    result.visibleSigma = visibleSigma(result, fit, measurement);
    if (result.visibleSigma > 10) return result;
  }
  return result;
}

/// A session by the protocol with `count` slips in adjacent readings: both circles of a row, or consecutive
/// rows (of adjacent places, or of the two faces of one place).
inline MistypedSession neighbouringErrors(const Protocol& protocol, std::size_t count, std::uint64_t seed,
                                          double step = 0.1) {
  std::mt19937_64 random(seed * 104729 + count);
  const auto pick = [&](std::size_t among) {
    return std::uniform_int_distribution<std::size_t>(0, among - 1)(random);
  };
  Truth truth = drawTruth(seed);
  truth.typingStep = Angle::fromArcseconds(step);
  const Session clean = *simulate(protocol, truth, seed);
  MistypedSession result{clean, {}, 0};
  const std::size_t position = pick(clean.positions.size());
  const auto& readings = clean.positions[position].readings;
  const std::size_t first = pick(readings.size() - 1), start = pick(2);
  const bool isOneColumn = pick(2) == 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = isOneColumn ? 2 * i + start : i + start;
    const Place where{.position = position,
                      .reading = std::min(first + at / 2, readings.size() - 1),
                      .field = at % 2 == 0 ? "horizontal" : "vertical"};
    std::string& text = cell(result.session, where);
    const std::string intended = text;
    if (std::ranges::find(result.cure, where, &CellChange::where) != result.cure.end()) continue;
    constexpr TypedError entryErrors[] = {TypedError::DigitsSwapped, TypedError::DigitWrong,
                                          TypedError::DegreeOff, TypedError::TenMinutesOff,
                                          TypedError::MinuteOff};
    for (int attempt = 0; attempt < 1000; ++attempt) {
      text = typedWrongly(intended, entryErrors[pick(std::size(entryErrors))], random);
      const auto wrong = parseAngle(text), right = parseAngle(intended);
      if (wrong && std::abs(wrapped(*wrong - *right).arcseconds()) > 25) break;
    }
    result.cure.push_back({where, intended});
  }
  return result;
}

/// The number of suspects with a correction that does not restore the correct text.
inline std::size_t falseOffers(const MistypedSession& mistyped, const std::vector<Suspect>& suspects) {
  const auto isFalse = [&](const CellChange& change) {
    const auto cure = std::ranges::find(mistyped.cure, change.where, &CellChange::where);
    return cure == mistyped.cure.end() || cure->text != change.text;
  };
  return static_cast<std::size_t>(std::ranges::count_if(suspects, [&](const Suspect& suspect) {
    return !suspect.proposals.empty() && std::ranges::any_of(suspect.proposals.front().changes, isFalse);
  }));
}

struct Found {
  bool rightCell = false;        ///< every cell at fault is named
  bool rightCorrection = false;  ///< and the first proposal restores the correct text
  std::size_t others = 0;        ///< sound cells that were named
};

inline Found judge(const MistypedSession& mistyped, const std::vector<Suspect>& suspects) {
  Found found{true, true, 0};
  const auto isCured = [&](const Place& where) {
    return std::ranges::any_of(mistyped.cure,
                               [&](const CellChange& change) { return change.where == where; });
  };
  for (const CellChange& change : mistyped.cure) {
    const auto suspect = std::ranges::find(suspects, change.where, &Suspect::where);
    found.rightCell = found.rightCell && suspect != suspects.end();
    Session cured = mistyped.session;
    if (suspect != suspects.end() && !suspect->proposals.empty())
      for (const CellChange& proposed : suspect->proposals.front().changes)
        cell(cured, proposed.where) = proposed.text;
    const std::string &is = cell(cured, change.where), &intended = change.text;
    found.rightCorrection =
        found.rightCorrection &&
        (is == intended || (change.where.field == "face" && intended.empty() && is == "1"));
  }
  for (const Suspect& suspect : suspects) found.others += isCured(suspect.where) ? 0 : 1;
  return found;
}

inline std::vector<Suspect> suspectsOf(const Session& session) {
  const Measurement measurement = *examine(session).measurement;
  return findSuspects(session, measurement, fitSession(measurement));
}

}  // namespace alidade::test
