#include "core/diagnosis/forms/session_forms.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "core/base/statistics.h"
#include "core/diagnosis/forms/find_forms.h"
#include "core/diagnosis/forms/found_form.h"
#include "core/diagnosis/forms/held_out_forms.h"
#include "core/diagnosis/result/thresholds.h"
#include "core/diagnosis/search/explained_model.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

Leftover leftoverOf(const GapModel& model) {
  return Leftover(linearise(*model.measurement, *model.fit, model.options), model.options.terms);
}

/// Adds every effect except those in `options.without`.
GapModel withEffects(const GapModel& plain, const EffectScales& scales, const DiagnosisOptions& options) {
  GapModel full = withEveryEffect(plain, scales);
  const auto isLeftOut = [&](const EstimatedTerm& term) {
    const Effect* const effect = effectOf(term.term, *plain.measurement);
    return effect && std::ranges::find(options.without, effect->id) != options.without.end();
  };
  if (std::erase_if(full.options.terms, isLeftOut) > 0) full.refit();
  return full.fit->converged() ? full : plain;
}

class SessionForms {
 public:
  SessionForms(const Inquiry& inquiry, const Explanation& certain, const EffectScales& scales,
               const DiagnosisOptions& options, const std::stop_token& stop)
      : m_inquiry(inquiry),
        m_stop(stop),
        m_plainModel(plainModel(inquiry, certain)),
        m_fullModel(withEffects(m_plainModel, scales, options)),
        m_plain(leftoverOf(m_plainModel)),
        m_full(leftoverOf(m_fullModel)),
        m_readings(formReadings(m_full, *m_fullModel.measurement, *m_fullModel.fit)),
        m_families(formFamilies(m_readings)),
        m_system(systemOf(m_full)) {
    for (const Part& part : certain.parts)
      if (inquiry.of(part).isJump()) addJump(part);
  }

  FoundForms find() {
    FoundForms result = findForms(
        m_system, m_readings, m_families,
        {.isNamed = [this](const std::vector<WeighedForm>& all) { return isNamed(all); },
         .isAnythingLeft = [this](int numbers) { return isAnythingLeft(m_system, numbers); },
         .note = [this](const WeighedForm& first, FoundForm& found) { addLookAlikes(first, found); }},
        m_stop);
    if (result.forms.empty()) return {};
    addShrinkage(result, divided(m_plain), divided(m_full), heldOut(result.families), m_readings,
                 m_system.variance(), m_stop);
    if (!predict(result.forms.front().shrink)) return {};
    addTraces(result, m_system.left(), m_full, *m_fullModel.measurement, m_readings);
    return result;
  }

 private:
  const Inquiry& m_inquiry;
  const std::stop_token& m_stop;
  GapModel m_plainModel, m_fullModel;  ///< with the certain causes except jumps; also with every effect
  Leftover m_plain, m_full;
  FormReadings m_readings;
  std::vector<FormFamily> m_families;
  FormSystem m_system;
  MatrixXd m_jumpColumns;  ///< columns of the jumps, over the readings

  static GapModel plainModel(const Inquiry& inquiry, Explanation certain) {
    std::erase_if(certain.parts, [&](const Part& part) { return inquiry.of(part).isJump(); });
    if (certain.parts.empty() && !certain.noisy) return inquiry.base;
    GapModel model = modelWith(inquiry.base, certain, inquiry.candidates, inquiry.leftover);
    return model.fit->isDetermined() ? model : inquiry.base;
  }

  static FormSystem systemOf(const Leftover& leftover) {
    const auto outside = [&leftover](const MatrixXd& columns) { return leftover.outsideArcAngles(columns); };
    return {outside, leftover.basis(), leftover.residual(), 1};
  }

  /// Absorbs a certain jump, unless forms explain the readings better without it.
  void addJump(const Part& part) {
    const Component& jump = m_inquiry.of(part);
    MatrixXd columns = jump.wholeColumns(m_inquiry.leftover);
    for (Index i = 0; i < columns.rows(); ++i)
      if (!m_full.reading(i).takesPart) columns.row(i).setZero();
    const FormSystem::Products products = m_system.productsOf(columns);
    const double ofJump =
        gainOf(jump.widths(), products.gram(0, columns.cols()), products.right, m_system.variance()).log +
        m_inquiry.candidates.groupOf(part.component).logPrior;
    FormSystem withJump = m_system;
    withJump.takeUp(columns);
    const double without = logSumOf(weighForms(m_system, m_readings, m_families, m_stop)),
                 with = ofJump + logSumOf(weighForms(withJump, m_readings, m_families, m_stop));
    if (without > with) return;
    m_system = std::move(withJump);
    const Index before = m_jumpColumns.cols();
    m_jumpColumns.conservativeResize(columns.rows(), before + columns.cols());
    m_jumpColumns.rightCols(columns.cols()) = columns;
  }

  /// Whether the leftover is larger than noise alone leaves in four of five sessions.
  bool isAnythingLeft(const FormSystem& system, int numbers) const {
    const double freedom = static_cast<double>(m_full.degreesOfFreedom() - numbers - m_jumpColumns.cols());
    return chiSquareUpperTail(system.left().squaredNorm() / system.variance(), freedom).value_or(0) <
           formThresholds.noiseAlone;
  }

  /// Whether the forms are likelier than no form and than the likeliest patterns. A form that leaves only
  /// noise may be up to 20 times less likely than the patterns, because some of them resemble the form.
  bool isNamed(const std::vector<WeighedForm>& all) const {
    if (!beatNothing(all)) return false;
    const double over = logSumOf(all) - logPatterns();
    if (over > 0 || over < -std::log(formThresholds.nearlyAsLikely)) return over > 0;
    const WeighedForm& first = all.front();
    FormSystem with = m_system;
    with.takeUp(formColumns(m_readings, first.form));
    return !isAnythingLeft(with, static_cast<int>(first.amplitudes.size()) + first.form.count());
  }

  /// Log odds (natural) of the likeliest patterns. Their prior is lower than that of forms, since they serve
  /// gaps without a form. Patterns of two columns are omitted, because a harmonic is a form itself.
  double logPatterns() const {
    std::set<std::size_t> seen;
    double count = 0, sum = impossible;
    for (std::size_t i = 0; i < m_inquiry.candidates.size(); ++i)
      count += m_inquiry.candidates[i].isShape() ? 1 : 0;
    for (const Explanation& explanation : m_inquiry.explanations) {
      if (!explanation.shaped || seen.size() == formThresholds.mostPatterns) continue;
      const Component& pattern = m_inquiry.of(explanation.parts.back());
      if (pattern.columns() <= 2 || !seen.insert(explanation.parts.back().component).second) continue;
      const FormSystem::Products products = m_system.productsOf(pattern.wholeColumns(m_inquiry.leftover));
      const MatrixXd gram = products.gram(0, products.all.cols());
      sum = logSum(sum, gainOf(pattern.widths(), gram, products.right, m_system.variance()).log +
                            std::log(formThresholds.ofPatterns / count));
    }
    return sum;
  }

  /// Adds the effects of the catalogue, of any size, that look like the form.
  void addLookAlikes(const WeighedForm& first, FoundForm& found) const {
    const Leftover& bare = m_inquiry.leftover;
    const VectorXd trace = bare.visible(formColumns(m_readings, first.form) * first.amplitudes);
    for (std::size_t i = 0; i < m_inquiry.candidates.size(); ++i) {
      const Component& component = m_inquiry.candidates[i];
      if (!component.isEffect()) continue;
      const MatrixXd columns = component.visibleColumns(bare).leftCols(component.weights());
      const VectorXd weights = columns.colPivHouseholderQr().solve(trace);
      if ((trace - columns * weights).norm() < thresholds.hardlyDifferent)
        found.indistinguishableFrom.push_back({first.form, std::string(component.id())});
    }
  }

  /// Whether the forms also fit held-out readings. A walk or wave with many numbers fits any readings in
  /// which it was found.
  static bool predict(const FormShrinkage& shrink) {
    return !(shrink.heldOut <= 0) || shrink.p < formThresholds.significant;
  }

  DividedModel divided(const Leftover& leftover) const {
    FormSystem system = systemOf(leftover);
    system.takeUp(m_jumpColumns);
    return {[&leftover](const MatrixXd& columns) { return leftover.outsideArcAngles(columns); },
            system.basis(), system.left()};
  }

  const Sighting& rowOf(Index i) const {
    const LinearReading& reading = m_full.reading(i);
    return m_fullModel.measurement->arcs[reading.arc].sightings[reading.sighting];
  }

  bool counts(Index i) const {
    const LinearReading& reading = m_full.reading(i);
    return reading.takesPart && !reading.isZero && reading.kind != ReadingKind::Slider;
  }

  /// Holds out whole rounds, or random visits if there is only one round or the form needs all rounds.
  HeldOutReadings heldOut(const std::vector<FormFamily>& chosen) const {
    constexpr int most = 4;
    const bool needsRounds = std::ranges::any_of(chosen, [](const FormFamily& family) {
      return family.form.of == FormArgument::T || family.form.of == FormArgument::Leg;
    });
    int rounds = 1;
    for (Index i = 0; i < m_readings.count; ++i)
      if (counts(i)) rounds = std::max(rounds, rowOf(i).round);
    const bool byRounds = rounds > 1 && !needsRounds;
    HeldOutReadings held{
        .fold = std::vector(static_cast<std::size_t>(m_readings.count), HeldOutReadings::none),
        .folds = byRounds ? std::min(rounds, most) : most,
        .arcseconds = VectorXd::Zero(m_readings.count)};
    held.eliminated.assign(static_cast<std::size_t>(held.folds), 0);
    const std::vector<int> shuffled = shuffledFolds(static_cast<std::size_t>(m_full.visits()), held.folds);
    for (Index v = 0; v < m_full.visits(); ++v) {
      const Leftover::Run run = m_full.readingsOf(v);
      if (run.length() == 0 || m_full.reading(run.first).isZero) continue;
      const int fold = byRounds ? (rowOf(run.first).round - 1) * held.folds / rounds
                                : shuffled[static_cast<std::size_t>(v)];
      addVisit(run, fold, held);
    }
    return held;
  }

  void addVisit(const Leftover::Run& run, int fold, HeldOutReadings& held) const {
    int lost = 0;
    bool hasArcAngle = false;
    for (Index i = run.first; i < run.end; ++i) {
      held.fold[static_cast<std::size_t>(i)] = fold;
      const LinearReading& reading = m_full.reading(i);
      lost += reading.takesPart ? 0 : 1;
      hasArcAngle = hasArcAngle || reading.along != 0;
      if (counts(i)) held.arcseconds[i] = Angle::fromRadians(reading.sigma).arcseconds();
    }
    held.eliminated[static_cast<std::size_t>(fold)] += lost + (hasArcAngle ? 1 : 0);
  }
};

}  // namespace

FoundForms formsBeyond(const Inquiry& inquiry, const Explanation& certain, const EffectScales& scales,
                       const DiagnosisOptions& options, const std::stop_token& stop) {
  constexpr Index mostReadings = 4000;  // with more readings the search takes seconds
  if (inquiry.leftover.readings() > mostReadings || stop.stop_requested()) return {};
  return SessionForms(inquiry, certain, scales, options, stop).find();
}

}  // namespace alidade
