#include "core/adjustment/suspects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/adjustment/misreadings.h"
#include "core/adjustment/visit_check.h"
#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/base/quantity_text.h"

namespace alidade {

namespace {

/// Of the misfit of a row that agrees: no stricter than what it takes to call a reading misread.
constexpr double leastProbability = 1e-4;
constexpr double leastShare = 0.01;  ///< of a proposal worth showing
constexpr double mostSliderDisagreement = 5;
constexpr std::size_t mostProposals = 5, mostUnusableRows = 12;

const char* fieldOf(ReadingKind kind) {
  if (kind == ReadingKind::Horizontal) return "horizontal";
  return kind == ReadingKind::Vertical ? "vertical" : "slider";
}

/// A changed face turns both circles; it is named by the horizontal one.
ReadingKind kindOf(const std::string& field) {
  if (field == "vertical") return ReadingKind::Vertical;
  return field == "slider" ? ReadingKind::Slider : ReadingKind::Horizontal;
}

/// The measurement with only those arcs that were fitted.
Measurement fittedPart(const Measurement& measurement, const SessionFit& fit) {
  Measurement part = measurement;
  std::erase_if(part.arcs, [&](const ArcMeasurement& arc) { return !fit.arcOfPosition(arc.position); });
  return part;
}

/// Reduced angles count face 2 and zenith circles the other way round than their circles.
double sideOf(const Measurement& measurement, int face, ReadingKind kind) {
  if (kind != ReadingKind::Vertical) return 1;
  const double down = measurement.verticalCircle == VerticalCircle::Zenith ? -1 : 1;
  return face == 1 ? down : -down;
}

/// In arcseconds up to two minutes, then in degrees, minutes and seconds; with its sign.
std::string signedSize(Angle size) {
  const double seconds = size.arcseconds();
  const std::string sign = seconds < 0 ? "" : "+";
  return sign + (std::abs(seconds) < 120 ? displayText(seconds, 1) + "″" : formatDms(size));
}

std::string nameOf(const Suspect& suspect) {
  std::string name = std::to_string(suspect.axisDeg) + "°, point " + std::to_string(suspect.point);
  if (suspect.round != 1) name += ", round " + std::to_string(suspect.round);
  if (suspect.face != 1) name += ", face " + std::to_string(suspect.face);
  return name + ", " + suspect.where.field;
}

const std::string& textAt(const Session& session, const Place& where) {
  const Reading& reading = session.positions[*where.position].readings[*where.reading];
  if (where.field == "face") return reading.face;
  if (where.field == "horizontal") return reading.horizontal;
  return where.field == "vertical" ? reading.vertical : reading.slider;
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

/// Horizontal 341°52'24" → 341°25'24": two digits swapped; residual then +1.2″.
std::string sentenceOf(const Session& session, const Correction& correction, Angle residual) {
  std::string sentence;
  for (const CellChange& change : correction.changes) {
    const std::string& typed = textAt(session, change.where);
    const bool otherRow = change.where.reading != correction.changes.front().where.reading;
    sentence += (sentence.empty() ? "" : ", ") +
                (sentence.empty() ? capitalised(change.where.field) : change.where.field) +
                (otherRow ? " of row " + std::to_string(*change.where.reading + 1) : "") + " " +
                (typed.empty() ? "(empty)" : typed) + " → " + change.text;
  }
  return sentence + ": " + slipName(correction.slip) + "; residual then " + signedSize(residual) + ".";
}

/// A visit in question, with the rows that belong to it as typed.
struct Visited {
  std::size_t arc = 0;
  int round = 1, point = 0;
  std::vector<std::size_t> rows;  ///< of the position
};

struct Tried {
  Correction correction;
  Sighting sighting;  ///< of the row in question, corrected
  double score = 0;   ///< logarithm of prior times likelihood
  Angle residual;     ///< of the first changed cell, as read
};

class SuspectSearch {
 public:
  SuspectSearch(const Session& session, Measurement fitted, const SuspectOptions& options)
      : m_session(session), m_fitted(std::move(fitted)), m_reader(session) {
    m_fitOptions.terms = estimatedTerms(m_fitted);
    m_search = searchMisreadings(m_fitted, {.risk = options.risk, .fit = m_fitOptions});
    m_sound = m_fitted;
    for (const MisreadReading& misread : m_search.misread) shiftReading(m_sound, misread.cell, misread.size);
    for (std::size_t arc = 0; arc < m_fitted.arcs.size(); ++arc) m_starts.push_back(circleOf(arc));
  }

  std::vector<Suspect> run() {
    for (const MisreadReading& misread : m_search.misread) {
      const Sighting& sighting = sightingOf(misread.cell);
      const Visited visit = visitOf(misread.cell.arc, sighting.round, sighting.point);
      if (!isNamed(visit)) lookAt(visit);
    }
    lookAtUnusableRows();
    return std::move(m_suspects);
  }

 private:
  const Sighting& sightingOf(const ReadingRef& cell) const {
    return m_fitted.arcs[cell.arc].sightings[cell.sighting];
  }

  Circle circleOf(std::size_t arc) const {
    const auto value = [&](Unknown::Kind kind) {
      return m_search.fit.values[m_search.fit.indexOf({.kind = kind, .arc = arc})];
    };
    return {value(Unknown::Kind::CentreX), value(Unknown::Kind::CentreY), value(Unknown::Kind::Radius)};
  }

  Visited visitOf(std::size_t arc, int round, int point) const {
    Visited visit{arc, round, point, {}};
    for (const Sighting& sighting : m_fitted.arcs[arc].sightings)
      if (sighting.round == round && sighting.point == point) visit.rows.push_back(sighting.row);
    return visit;
  }

  static Visited withRow(Visited visit, std::size_t row) {
    if (std::ranges::find(visit.rows, row) == visit.rows.end()) visit.rows.push_back(row);
    std::ranges::sort(visit.rows);
    return visit;
  }

  /// A row of the visit is among the suspects already: the slip that explains them both was found.
  bool isNamed(const Visited& visit) const {
    return std::ranges::any_of(m_suspects, [&](const Suspect& suspect) {
      return suspect.where.position == m_fitted.arcs[visit.arc].position &&
             std::ranges::find(visit.rows, *suspect.where.reading) != visit.rows.end();
    });
  }

  std::vector<MisreadReading> misreadIn(const Visited& visit) const {
    std::vector<MisreadReading> misread;
    std::ranges::copy_if(m_search.misread, std::back_inserter(misread), [&](const MisreadReading& m) {
      const Sighting& sighting = sightingOf(m.cell);
      return m.cell.arc == visit.arc && sighting.round == visit.round && sighting.point == visit.point;
    });
    return misread;
  }

  /// Against a fit without the visits in question. Among very many rows two visits weigh nothing.
  VisitCheck checkOf(const Visited& visit, const Visited* other = nullptr) const {
    constexpr std::size_t veryMany = 2000;
    auto inQuestion = readingsOf(m_sound, visit.arc, visit.round, visit.point);
    if (other)
      std::ranges::copy(readingsOf(m_sound, other->arc, other->round, other->point),
                        std::back_inserter(inQuestion));
    JointFitOptions options = m_fitOptions;
    options.without = m_search.leftOut;
    options.without.insert(options.without.end(), inQuestion.begin(), inQuestion.end());
    if (m_fitted.rows > veryMany)
      return VisitCheck(m_sound, visit.arc, options.without, m_search.fit, options);
    return VisitCheck(m_sound, visit.arc, options.without, fitJointly(m_sound, m_starts, options), options);
  }

  /// The rows of the visit with a correction, less the shifts of misread cells that it leaves alone; empty
  /// where they cannot be used.
  std::vector<Sighting> rowsWith(const Visited& visit, const Correction& correction,
                                 const std::vector<MisreadReading>& keptOff) {
    const std::size_t position = m_fitted.arcs[visit.arc].position;
    std::vector<Sighting> rows;
    for (const std::size_t row : visit.rows) {
      const auto changed = correction.rows.find(row);
      const Reading& reading =
          changed == correction.rows.end() ? m_session.positions[position].readings[row] : changed->second;
      const auto sighting = m_reader.read(position, row, reading);
      if (!sighting) return {};
      if (std::ranges::find(rows, sighting->face, &Sighting::face) != rows.end()) return {};
      rows.push_back(*sighting);
      for (const MisreadReading& misread : keptOff) {
        if (sightingOf(misread.cell).row != row) continue;
        Measurement alone;
        alone.arcs.resize(1);
        alone.arcs[0].sightings = {rows.back()};
        shiftReading(alone, {0, 0, misread.cell.kind}, misread.size);
        rows.back() = alone.arcs[0].sightings[0];
      }
    }
    return rows;
  }

  /// What the correction does to the visits of other rows it changes: the gain in likelihood; empty where
  /// they do not agree then.
  std::optional<double> gainElsewhere(const Visited& visit, const Correction& correction) {
    const ArcMeasurement& arc = m_fitted.arcs[visit.arc];
    double gain = 0;
    for (const auto& [row, reading] : correction.rows) {
      if (std::ranges::find(visit.rows, row) != visit.rows.end()) continue;
      const auto other = m_reader.read(arc.position, row, reading);
      if (!other) return std::nullopt;
      const Visited otherVisit = withRow(visitOf(visit.arc, other->round, other->point), row);
      const auto as = rowsWith(otherVisit, {}, {}), corrected = rowsWith(otherVisit, correction, {});
      if (corrected.empty()) return std::nullopt;
      const VisitCheck check = checkOf(visit, &otherVisit);
      if (!check.canCheck()) return std::nullopt;
      const VisitAgreement after = check.agreement(corrected);
      if (after.probability < leastProbability) return std::nullopt;
      constexpr double unusable = -50;  // as typed it cannot have been meant
      gain += after.logLikelihood - (as.empty() ? unusable : check.agreement(as).logLikelihood);
    }
    return gain;
  }

  /// Of slider readings typed in both rows of a visit, where one reading was made, in σ.
  double sliderDisagreement(const std::vector<Sighting>& rows) const {
    if (rows.size() < 2 || !rows[0].slider || !rows[1].slider) return 0;
    return std::abs(wrapped(*rows[0].slider - *rows[1].slider).radians()) / m_fitted.sigmaSlider.radians();
  }

  std::optional<Tried> tryOut(const Visited& visit, const VisitCheck& check, const Correction& correction,
                              const std::vector<MisreadReading>& keptOff) {
    const std::vector<Sighting> rows = rowsWith(visit, correction, keptOff);
    if (rows.empty()) return std::nullopt;
    const VisitAgreement agreement = check.agreement(rows);
    const double slider = sliderDisagreement(rows);
    if (agreement.probability < leastProbability || slider > mostSliderDisagreement) return std::nullopt;
    const auto elsewhere = gainElsewhere(visit, correction);
    if (!elsewhere) return std::nullopt;
    const Place& first = correction.changes.front().where;
    const auto row = std::ranges::find(rows, *first.reading, &Sighting::row);
    const ReadingKind kind = kindOf(first.field);
    const std::size_t index = kind == ReadingKind::Slider ? agreement.residuals.size() - 1
                                                          : 2 * static_cast<std::size_t>(row - rows.begin()) +
                                                                (kind == ReadingKind::Vertical ? 1 : 0);
    return Tried{correction, *row,
                 std::log(correction.prior) + agreement.logLikelihood + *elsewhere - slider * slider / 2,
                 Angle::fromRadians(agreement.residuals[index] * sideOf(m_fitted, row->face, kind))};
  }

  /// The corrections that make the visit agree, the most probable first. With `only`, of that cell alone.
  std::vector<Tried> agreeing(const Visited& visit, const VisitCheck& check,
                              const std::vector<MisreadReading>& keptOff, const ReadingRef* only = nullptr) {
    std::vector<Tried> tried;
    if (!check.canCheck()) return tried;
    const std::size_t position = m_fitted.arcs[visit.arc].position;
    for (const std::size_t row : visit.rows) {
      if (only && sightingOf(*only).row != row) continue;
      for (const Correction& correction : correctionsOf(m_session, position, row)) {
        if (only &&
            (correction.changes.size() > 1 || correction.changes.front().where.field != fieldOf(only->kind)))
          continue;
        if (auto one = tryOut(visit, check, correction, keptOff)) tried.push_back(*std::move(one));
      }
    }
    std::ranges::stable_sort(tried, std::ranges::greater(), &Tried::score);
    return tried;
  }

  std::vector<Proposal> proposalsOf(const std::vector<Tried>& tried) const {
    double sum = 0;
    for (const Tried& one : tried) sum += std::exp(one.score - tried.front().score);
    std::vector<Proposal> proposals;
    for (const Tried& one : tried) {
      const double share = std::exp(one.score - tried.front().score) / sum;
      if (share < leastShare || proposals.size() >= mostProposals) break;
      proposals.push_back(
          {one.correction.changes, one.residual, share, sentenceOf(m_session, one.correction, one.residual)});
    }
    return proposals;
  }

  void lookAt(const Visited& visit) {
    const std::vector<MisreadReading> misread = misreadIn(visit);
    const VisitCheck check = checkOf(visit);
    const std::vector<Tried> tried = agreeing(visit, check, {});
    if (!tried.empty()) {
      nameCells(visit, tried, misread.front().studentised);
      return;
    }
    // More than one slip in the visit, or none that explains it.
    for (const MisreadReading& one : misread) {
      std::vector<MisreadReading> others = misread;
      std::erase_if(others, [&](const MisreadReading& m) { return m.cell == one.cell; });
      name(one, others.empty() ? std::vector<Tried>{} : agreeing(visit, check, others, &one.cell));
    }
  }

  Suspect suspectAt(const Visited& visit, const Sighting& sighting, const Place& where) const {
    Suspect suspect;
    suspect.where = where;
    suspect.axisDeg = m_fitted.arcs[visit.arc].axisDeg;
    suspect.point = sighting.point;
    suspect.round = sighting.round;
    suspect.face = sighting.face;
    suspect.kind = kindOf(where.field);
    return suspect;
  }

  void finish(Suspect suspect) {
    suspect.sentence = nameOf(suspect) + ": " +
                       (suspect.where.field == "face"           ? "the other face"
                        : std::isfinite(suspect.size.radians()) ? "off by " + signedSize(suspect.size)
                                                                : "no angle") +
                       ". " +
                       (suspect.proposals.empty() ? "No single slip explains it: read it again."
                                                  : "Probably meant: " + suspect.proposals.front().sentence);
    m_suspects.push_back(std::move(suspect));
  }

  /// The cells that the most probable correction changes.
  void nameCells(const Visited& visit, const std::vector<Tried>& tried, double studentised) {
    const Tried& best = tried.front();
    const std::size_t position = m_fitted.arcs[visit.arc].position;
    for (const CellChange& change : best.correction.changes) {
      Sighting sighting = best.sighting;
      if (change.where.reading != sighting.row) {
        const auto read =
            m_reader.read(position, *change.where.reading, best.correction.rows.at(*change.where.reading));
        if (read) sighting = *read;
      }
      Suspect suspect = suspectAt(visit, sighting, change.where);
      suspect.studentised = studentised;
      suspect.size = sizeOf(change, best);
      suspect.proposals = proposalsOf(tried);
      for (const Proposal& proposal : suspect.proposals)
        if (proposal.share > 0.05) addRivals(suspect, proposal, best);
      finish(std::move(suspect));
    }
  }

  static void addRivals(Suspect& suspect, const Proposal& proposal, const Tried& best) {
    for (const CellChange& change : proposal.changes) {
      const bool isBest = std::ranges::any_of(
          best.correction.changes, [&](const CellChange& own) { return own.where == change.where; });
      if (!isBest && std::ranges::find(suspect.rivals, change.where) == suspect.rivals.end())
        suspect.rivals.push_back(change.where);
    }
  }

  Angle sizeOf(const CellChange& change, const Tried& best) const {
    if (change.where.field == "face") return Angle::fromDegrees(180);
    const auto typed = parseAngle(textAt(m_session, change.where)), meant = parseAngle(change.text);
    if (!typed || !meant) return Angle::fromRadians(std::numeric_limits<double>::quiet_NaN());
    const bool isFirst = change.where == best.correction.changes.front().where;
    return wrapped(*typed - *meant) + (isFirst ? best.residual : Angle());
  }

  /// The cell that the search blames.
  void name(const MisreadReading& misread, const std::vector<Tried>& tried) {
    const Sighting& sighting = sightingOf(misread.cell);
    const Visited visit = visitOf(misread.cell.arc, sighting.round, sighting.point);
    const auto placeOf = [&](const ReadingRef& cell) {
      return Place{.position = m_fitted.arcs[cell.arc].position,
                   .reading = sightingOf(cell).row,
                   .field = fieldOf(cell.kind)};
    };
    Suspect suspect = suspectAt(visit, sighting, placeOf(misread.cell));
    suspect.size = misread.size * sideOf(m_fitted, sighting.face, misread.cell.kind);
    suspect.studentised = misread.studentised;
    for (const ReadingRef& rival : misread.rivals) suspect.rivals.push_back(placeOf(rival));
    if (!tried.empty()) suspect.proposals = proposalsOf(tried);
    finish(std::move(suspect));
  }

  /// Rows that `examine` had to leave out, where a slip explains why.
  void lookAtUnusableRows() {
    std::size_t looked = 0;
    for (std::size_t arc = 0; arc < m_fitted.arcs.size(); ++arc) {
      const std::size_t position = m_fitted.arcs[arc].position;
      const auto& readings = m_session.positions[position].readings;
      for (std::size_t row = 0; row < readings.size() && looked < mostUnusableRows; ++row) {
        if (readings[row].excluded || readings[row].horizontal.empty() || readings[row].vertical.empty() ||
            std::ranges::find(m_fitted.arcs[arc].sightings, row, &Sighting::row) !=
                m_fitted.arcs[arc].sightings.end())
          continue;
        if (isNamed({arc, 0, 0, {row}})) continue;
        ++looked;
        lookAtUnusable(arc, row);
      }
    }
  }

  void lookAtUnusable(std::size_t arc, std::size_t row) {
    const auto& readings = m_session.positions[m_fitted.arcs[arc].position].readings;
    const auto pointOf = [&](std::size_t r) { return wholeOr(readings[r].point, static_cast<int>(r) + 1); };
    const auto roundOf = [&](std::size_t r) { return wholeOr(readings[r].round, 1); };
    const Visited usable = visitOf(arc, roundOf(row), pointOf(row));
    const VisitCheck check = checkOf(usable);
    if (!check.canCheck()) return;
    // The row may have nothing wrong with it: its face or point is taken by another.
    const Visited alone{arc, usable.round, usable.point, {row}};
    const auto asTyped = rowsWith(alone, {}, {});
    if (!asTyped.empty() && check.agreement(asTyped).probability >= leastProbability) return;
    Visited all = withRow(usable, row);
    for (std::size_t r = 0; r < readings.size(); ++r)
      if (!readings[r].excluded && roundOf(r) == usable.round && pointOf(r) == usable.point)
        all = withRow(all, r);
    for (const Visited& visit : {all, withRow(usable, row)}) {
      std::vector<Tried> tried = agreeing(visit, check, {});
      std::erase_if(tried, [&](const Tried& one) { return !one.correction.rows.contains(row); });
      if (tried.empty()) continue;
      nameCells(visit, tried, 0);
      return;
    }
  }

  static int wholeOr(const std::string& text, int fallback) {
    const auto number = parseWhole(text);
    return number ? *number : fallback;
  }

  const Session& m_session;
  Measurement m_fitted;
  RowReader m_reader;
  JointFitOptions m_fitOptions;
  MisreadingSearch m_search;
  Measurement m_sound;  ///< the shifts taken off all misread readings
  std::vector<Circle> m_starts;
  std::vector<Suspect> m_suspects;
};

}  // namespace

std::vector<Suspect> findSuspects(const Session& session, const Measurement& measurement,
                                  const SessionFit& fit, const SuspectOptions& options) {
  if (fit.arcs.empty()) return {};
  return SuspectSearch(session, fittedPart(measurement, fit), options).run();
}

std::optional<Finding> suspectsFinding(const std::vector<Suspect>& suspects) {
  if (suspects.empty()) return std::nullopt;
  std::string names;
  for (const Suspect& suspect : suspects) names += (names.empty() ? "" : "; ") + nameOf(suspect);
  const bool one = suspects.size() == 1;
  const std::string it = one ? "it" : "them";
  return Finding{
      Severity::Warning,
      (one ? "A reading looks misread: " : std::to_string(suspects.size()) + " readings look misread: ") +
          names + ".",
      "Check " + it + " in the field book, then correct or exclude " + it +
          "; until then every usable reading takes part in the result.",
      one ? suspects.front().where : Place{}};
}

}  // namespace alidade
