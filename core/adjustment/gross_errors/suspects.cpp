#include "core/adjustment/gross_errors/suspects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/adjustment/gross_errors/correction_trials.h"
#include "core/base/angle_text.h"
#include "core/base/number_text.h"
#include "core/session/row_fields.h"

namespace alidade {

namespace {

constexpr double leastShare = 0.01;              ///< of a proposal worth showing
constexpr double leastShareAmongSeveral = 0.95;  ///< of a proposal if there are other suspects
/// Largest deviation of a corrected place, in units of the scatter of all others; more means another error.
constexpr double mostOffSpacing = 12;
constexpr std::size_t mostProposals = 5, mostUnusableRows = 12;

class SuspectSearch {
 public:
  SuspectSearch(const Session& session, Measurement fitted, const JointFit& fit,
                const SuspectOptions& options, const std::stop_token& stop)
      : m_session(session),
        m_stop(stop),
        m_reader(session),
        m_trials(session, std::move(fitted), fit, options.risk, stop) {}

  std::vector<Suspect> run() {
    for (const GrossError& error : m_trials.grossErrors()) {
      if (m_stop.stop_requested()) return std::move(m_suspects);
      const Sighting& sighting = m_trials.sightingOf(error.cell);
      const Visited visit = m_trials.visitOf(error.cell.arc, sighting.round, sighting.point);
      if (!isNamed(visit)) lookAt(visit);
    }
    lookAtUnusableRows();
    if (!m_stop.stop_requested()) keepWhatHoldsTogether();
    return std::move(m_suspects);
  }

 private:
  /// Is a row of the visit already among the suspects? Then the errors of the visit were already explained.
  bool isNamed(const Visited& visit) const {
    return std::ranges::any_of(m_suspects, [&](const Suspect& suspect) {
      return suspect.where.position == m_trials.measurement().arcs[visit.arc].position &&
             std::ranges::find(visit.rows, *suspect.where.reading) != visit.rows.end();
    });
  }

  std::vector<Proposal> proposalsOf(const std::vector<AgreeingCorrection>& tried) const {
    double sum = 0;
    for (const AgreeingCorrection& one : tried) sum += std::exp(one.score - tried.front().score);
    std::vector<Proposal> proposals;
    for (const AgreeingCorrection& one : tried) {
      const double share = std::exp(one.score - tried.front().score) / sum;
      if (share < leastShare || proposals.size() >= mostProposals) break;
      proposals.push_back({one.correction.error, one.correction.changes, one.residual, share});
    }
    return proposals;
  }

  void lookAt(const Visited& visit) {
    const std::vector<GrossError> errors = m_trials.grossErrorsIn(visit);
    const VisitCheck check = m_trials.checkOf(visit);
    const std::vector<AgreeingCorrection> tried = m_trials.agreeing(visit, check);
    if (!tried.empty()) {
      nameCells(visit, tried, errors.front().studentised);
      return;
    }
    // The visit has more than one entry error, or an error that no correction explains.
    for (const GrossError& one : errors) {
      std::vector<GrossError> others = errors;
      std::erase_if(others, [&](const GrossError& m) { return m.cell == one.cell; });
      name(one, others.empty() ? std::vector<AgreeingCorrection>{}
                               : m_trials.agreeing(visit, check, others, &one.cell));
    }
  }

  Suspect suspectAt(const Visited& visit, const Sighting& sighting, const Place& where) const {
    Suspect suspect;
    suspect.where = where;
    suspect.axisDeg = m_trials.measurement().arcs[visit.arc].axisDeg;
    suspect.repeat = m_trials.measurement().arcs[visit.arc].repeat;
    suspect.point = sighting.point;
    suspect.round = sighting.round;
    suspect.face = sighting.face;
    suspect.kind = kindOf(where.field);
    return suspect;
  }

  /// Names the cells that the most probable correction changes.
  void nameCells(const Visited& visit, const std::vector<AgreeingCorrection>& tried, double studentised) {
    const AgreeingCorrection& best = tried.front();
    const std::size_t position = m_trials.measurement().arcs[visit.arc].position;
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
      if (best.offSpacing > mostOffSpacing) mask(suspect);
      m_suspects.push_back(std::move(suspect));
    }
  }

  static void addRivals(Suspect& suspect, const Proposal& proposal, const AgreeingCorrection& best) {
    for (const CellChange& change : proposal.changes) {
      const bool isBest = std::ranges::any_of(
          best.correction.changes, [&](const CellChange& own) { return own.where == change.where; });
      if (!isBest && std::ranges::find(suspect.rivals, change.where) == suspect.rivals.end())
        suspect.rivals.push_back(change.where);
    }
  }

  static Angle sizeOf(const CellChange& change, const AgreeingCorrection& best) {
    if (change.where.field == "face") return Angle::fromDegrees(180);
    const auto typed = parseAngle(change.typed), intended = parseAngle(change.text);
    if (!typed || !intended) return Angle::fromRadians(std::numeric_limits<double>::quiet_NaN());
    const bool isFirst = change.where == best.correction.changes.front().where;
    return wrapped(*typed - *intended) + (isFirst ? best.residual : Angle());
  }

  /// Names the cell that the search found.
  void name(const GrossError& error, const std::vector<AgreeingCorrection>& tried) {
    const Sighting& sighting = m_trials.sightingOf(error.cell);
    const Visited visit = m_trials.visitOf(error.cell.arc, sighting.round, sighting.point);
    const auto placeOf = [&](const ReadingRef& cell) {
      return Place{.position = m_trials.measurement().arcs[cell.arc].position,
                   .reading = m_trials.sightingOf(cell).row,
                   .field = std::string(nameOf(cell.kind))};
    };
    Suspect suspect = suspectAt(visit, sighting, placeOf(error.cell));
    suspect.size = error.size * sideOf(m_trials.measurement(), sighting.face, error.cell.kind);
    suspect.studentised = error.studentised;
    for (const ReadingRef& rival : error.rivals) suspect.rivals.push_back(placeOf(rival));
    if (!tried.empty()) suspect.proposals = proposalsOf(tried);
    m_suspects.push_back(std::move(suspect));
  }

  /// Tests the rows that `examine` left out, and names those that an entry error explains.
  void lookAtUnusableRows() {
    std::size_t looked = 0;
    for (std::size_t arc = 0; arc < m_trials.measurement().arcs.size(); ++arc) {
      const std::size_t position = m_trials.measurement().arcs[arc].position;
      const auto& readings = m_session.positions[position].readings;
      std::vector<bool> isUsable(readings.size());
      for (const Sighting& sighting : m_trials.measurement().arcs[arc].sightings)
        isUsable[sighting.row] = true;
      for (std::size_t row = 0; row < readings.size() && looked < mostUnusableRows; ++row) {
        if (m_stop.stop_requested()) return;
        if (isUsable[row] || readings[row].excluded || readings[row].horizontal.empty() ||
            readings[row].vertical.empty() || isNamed({arc, 0, 0, {row}}))
          continue;
        ++looked;
        lookAtUnusable(arc, row);
      }
    }
  }

  void lookAtUnusable(std::size_t arc, std::size_t row) {
    const auto& readings = m_session.positions[m_trials.measurement().arcs[arc].position].readings;
    const auto pointOf = [&](std::size_t r) { return wholeOr(readings[r].point, static_cast<int>(r) + 1); };
    const auto roundOf = [&](std::size_t r) { return wholeOr(readings[r].round, 1); };
    const Visited usable = m_trials.visitOf(arc, roundOf(row), pointOf(row));
    const VisitCheck check = m_trials.checkOf(usable);
    if (!check.canCheck()) return;
    // The row itself may be right if another row states its face or point by mistake.
    const Visited alone{arc, usable.round, usable.point, {row}};
    if (m_trials.agreesAsTyped(alone, check)) return;
    Visited all = usable.with(row);
    for (std::size_t r = 0; r < readings.size(); ++r)
      if (!readings[r].excluded && roundOf(r) == usable.round && pointOf(r) == usable.point)
        all = all.with(r);
    for (const Visited& visit : {all, usable.with(row)}) {
      std::vector<AgreeingCorrection> tried = m_trials.agreeing(visit, check);
      std::erase_if(tried, [&](const AgreeingCorrection& one) { return !one.correction.rows.contains(row); });
      if (tried.empty()) continue;
      nameCells(visit, tried, 0);
      return;
    }
  }

  static void mask(Suspect& suspect) {
    suspect.isMasked = suspect.isMasked || !suspect.proposals.empty();
    suspect.proposals.clear();
  }

  /// Are both suspects of one visit, so that each hides the residual of the other?
  static bool areTogether(const Suspect& a, const Suspect& b) {
    return a.where.position == b.where.position && a.round == b.round && a.point == b.point;
  }

  static bool areOneError(const Suspect& a, const Suspect& b) {
    return !a.proposals.empty() && !b.proposals.empty() &&
           a.proposals.front().changes == b.proposals.front().changes;
  }

  bool hasOther(const Suspect& suspect) const {
    return std::ranges::any_of(
        m_suspects, [&](const Suspect& other) { return &other != &suspect && !areOneError(suspect, other); });
  }

  /// With other misread readings present, keeps a correction only if it is almost certain and leaves nothing
  /// in its visit unexplained. All readings must also agree once every suspect is corrected.
  void keepWhatHoldsTogether() {
    std::vector<bool> isDoubtful;
    for (const Suspect& suspect : m_suspects) {
      const bool isUnsure =
          !suspect.proposals.empty() && suspect.proposals.front().share < leastShareAmongSeveral;
      const bool hasUnexplained = std::ranges::any_of(m_suspects, [&](const Suspect& other) {
        return other.proposals.empty() && areTogether(suspect, other);
      });
      isDoubtful.push_back((isUnsure && hasOther(suspect)) || hasUnexplained);
    }
    for (std::size_t i = 0; i < m_suspects.size(); ++i)
      if (isDoubtful[i]) mask(m_suspects[i]);
    if (std::ranges::none_of(m_suspects, [&](const Suspect& suspect) { return hasOther(suspect); })) return;
    for (const Suspect& left : leftOnceCorrected())
      for (Suspect& suspect : m_suspects)
        if (areTogether(suspect, left)) mask(suspect);
  }

  /// The visits that still disagree once every suspect is corrected, or excluded if it has no proposal.
  std::vector<Suspect> leftOnceCorrected() const {
    Session mended = m_session;
    for (const Suspect& suspect : m_suspects) {
      auto& readings = mended.positions[*suspect.where.position].readings;
      if (suspect.proposals.empty()) {
        readings[*suspect.where.reading].excluded = true;
        continue;
      }
      for (const CellChange& change : suspect.proposals.front().changes)
        readings[*change.where.reading].*rowFieldNamed(change.where.field)->text = change.text;
    }
    const Examined examined = examine(mended);
    if (!examined.measurement) return {};
    const SessionFit fit = fitSession(*examined.measurement);
    if (fit.arcs.empty()) return {};
    const Measurement fitted = fittedPart(*examined.measurement, fit);
    std::vector<Suspect> left;
    for (const GrossError& error :
         searchGrossErrors(fitted, {.fit = {.terms = estimatedTerms(fitted)}, .known = &fit.joint}, m_stop)
             .grossErrors) {
      const ArcMeasurement& arc = fitted.arcs[error.cell.arc];
      Suspect suspect;
      suspect.where.position = arc.position;
      suspect.round = arc.sightings[error.cell.sighting].round;
      suspect.point = arc.sightings[error.cell.sighting].point;
      left.push_back(suspect);
    }
    return left;
  }

  static int wholeOr(const std::string& text, int fallback) {
    const auto number = parseWhole(text);
    return number ? *number : fallback;
  }

  const Session& m_session;
  const std::stop_token& m_stop;
  RowReader m_reader;
  CorrectionTrials m_trials;
  std::vector<Suspect> m_suspects;
};

}  // namespace

std::vector<Suspect> findSuspects(const Session& session, const Measurement& measurement,
                                  const SessionFit& fit, const SuspectOptions& options,
                                  const std::stop_token& stop) {
  if (fit.arcs.empty()) return {};
  return SuspectSearch(session, fittedPart(measurement, fit), fit.joint, options, stop).run();
}

}  // namespace alidade
