#include <algorithm>
#include <cmath>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/statistics.h"
#include "core/effects/catalogue.h"
#include "core/evaluation/remedies.h"
#include "core/statement/gap.h"
#include "core/wording/closures.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/effect_name.h"
#include "core/wording/form_sentence.h"
#include "core/wording/position_name.h"
#include "core/wording/size_text.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

using Role = Statement::Column::Role;
using Row = Statement::Row;

/// The change of the gap by a cause, and the share of the gap that it removes.
struct Change {
  std::string text = "—";
  std::optional<double> share = {};
};

std::optional<double> shareGone(double before, double after) {
  const double share = 1 - after / before;
  constexpr double noticeable = 0.005;
  return share > noticeable ? std::optional(share) : std::nullopt;
}

/// The change of the largest misclosure among the closures that fail before and hold after.
Change closing(const std::vector<Closure>& before, const std::vector<Closure>& after) {
  Change change;
  double largest = 0;
  for (const Closure& open : before) {
    const auto closed = std::ranges::find_if(
        after, [&](const Closure& other) { return other.of == open.of && other.repeated == open.repeated; });
    if (!fails(open) || closed == after.end() || fails(*closed) || open.sigmas() < largest) continue;
    largest = open.sigmas();
    change = {Phrase::of("closes %1: %2 σ → %3 σ", nameInWords(open), displayText(open.sigmas(), 1),
                         displayText(closed->sigmas(), 1)),
              shareGone(open.sigmas(), closed->sigmas())};
  }
  return change;
}

Change shrinking(double before, double after) {
  const auto share = shareGone(before, after);
  if (!share) return {};
  const int decimals = displayText(before, 1) == displayText(after, 1) ? 2 : 1;
  return {Phrase::of("residuals %1″ → %2″", displayText(before, decimals), displayText(after, decimals)),
          share};
}

Change calming(double before, double after) {
  const auto share = shareGone(before, after);
  if (!share) return {};
  return {Phrase::of("reduced χ² %1 → %2", displayText(before, 2), displayText(after, 2)), share};
}

/// The change by a step of the diagnosis: that of a closure or of the residuals, whichever shrinks more. If
/// neither shrinks noticeably, that of reduced χ².
Change changeByStep(const Diagnosis& diagnosis, std::size_t step) {
  std::vector<Closure> closures;
  for (const ClosureStep& closure : diagnosis.closures) closures.push_back(closure.before);
  const GapStep& after = diagnosis.steps[step];
  const GapSize& size = step > 0 ? diagnosis.steps[step - 1].size : diagnosis.gap;
  const Change closed = closing(step > 0 ? diagnosis.steps[step - 1].closures : closures, after.closures),
               shrunk = shrinking(size.rms, after.size.rms);
  if (closed.share && closed.share >= shrunk.share.value_or(0)) return closed;
  return shrunk.share ? shrunk : calming(size.reducedChiSquare, after.size.reducedChiSquare);
}

/// The rows of one gap.
class Rows {
 public:
  explicit Rows(const Gap& gap)
      : m_gap(gap),
        m_coverage(
            coverageFactor(gap.evaluation->examined.measurement->coverage, DegreesOfFreedom::infinite())) {
    const Diagnosis& diagnosis = *gap.diagnosis;
    for (const Cause& cause : diagnosis.causes) add(cause);
    for (std::size_t i = 0; i < diagnosis.forms.size(); ++i) add(diagnosis.forms[i], i == 0);
    if (diagnosis.shape && diagnosis.forms.empty()) add(*diagnosis.shape);
    for (std::size_t i = 1; i < gap.stages.size(); ++i)
      if (gap.stages[i].kind == GapStage::Kind::InModel) addOfModel(gap.stages[i], gap.stages[i - 1].rms);
  }

  std::vector<Row> rows;

 private:
  static Row row(std::string name, std::string probability, Change change, std::string alike) {
    return {.cells = {std::move(name), "", std::move(probability), std::move(change.text), std::move(alike)},
            .bar = change.share};
  }

  void addPart(std::string name, std::string size) {
    rows.push_back({.cells = {std::move(name), std::move(size), "", "", ""}, .isPart = true});
  }

  std::string sizeOf(double value, double sigma, const std::string& unit) const {
    constexpr double digits = 1e9;  // beyond them is rounding
    if (isExact(value, sigma)) return displayShortest(std::round(value * digits) / digits) + signOf(unit);
    return sizeWithExpanded(value, m_coverage * sigma, unit);
  }

  /// Puts a single number beside the name, and several numbers into parts below it.
  void addSizes(const std::vector<CauseParameter>& all) {
    std::vector<CauseParameter> numbers = all;
    std::erase_if(numbers, [](const CauseParameter& number) { return !(number.sigma > 0); });
    if (numbers.size() == 1)
      rows.back().cells[1] = sizeOf(numbers[0].value, numbers[0].sigma, numbers[0].unit);
    else
      for (const CauseParameter& number : numbers)
        addPart(parameterName(number.name), sizeOf(number.value, number.sigma, number.unit));
  }

  Row rowOf(const std::string& id, std::string probability, Change change, std::string alike) const {
    Row made = row(causeTitle(id), std::move(probability), std::move(change), std::move(alike));
    made.id = id;
    if (const Effect* effect = effectById(id))
      //: what an effect is, as a sentence of its own
      made.about = Phrase::of("%1.", withCapital(Phrase::of(effect->description)));
    return made;
  }

  /// The change by the first step of the effect that no row lists yet. One effect may be two causes, such as
  /// misread values at two places.
  Change changeBy(const Cause& cause) {
    const auto& steps = m_gap.diagnosis->steps;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (steps[i].effect != cause.effect || std::ranges::find(m_listedSteps, i) != m_listedSteps.end())
        continue;
      m_listedSteps.push_back(i);
      return changeByStep(*m_gap.diagnosis, i);
    }
    return {};
  }

  void add(const Cause& cause) {
    rows.push_back(rowOf(cause.effect, shortProbabilityText(cause.probability), changeBy(cause),
                         causeNames(cause.indistinguishableFrom, Phrase::of(" or "))));
    addSizes(cause.parameters);
    if (const auto jump = jumpOf(m_gap, cause)) addPart(momentText(*jump), "");
    for (const ReadingDeviation& reading : cause.readings)
      addPart(readingName(reading), secondsWithSign(reading.size));
  }

  std::string momentText(const Jump& jump) const {
    const auto& arcs = m_gap.evaluation->examined.measurement->arcs;
    const auto arc = std::ranges::find(arcs, *jump.place.position, &ArcMeasurement::position);
    //: a position and a row of it: "before 0°, row 35"
    return Phrase::of("before %1, row %2", positionName(arc->axisDeg, arc->repeat), *jump.place.reading + 1);
  }

  void add(const FoundForm& form, bool isFirst) {
    Change change;
    if (isFirst && !m_gap.diagnosis->steps.empty())  // all forms together are the last step
      change = changeByStep(*m_gap.diagnosis, m_gap.diagnosis->steps.size() - 1);
    //: what a form is carried by, and its function: "Form: radius, cos 7s"
    rows.push_back(row(Phrase::of("Form: %1", kindText(form.form)), shortProbabilityText(form.probability),
                       std::move(change), lookAlikesText(form)));
    const std::size_t own = rows.size() - 1;
    for (const FormNumber& number : form.parameters) {
      const std::string size = sizeOf(number.value, number.sigma, unitOf(number));
      if (number.name.starts_with("amplitude"))
        rows[own].cells[1] = size;
      else
        addPart(alidade::nameOf(number), size);
    }
  }

  void add(const GapShape& shape) {
    rows.push_back(row(Phrase::of("Pattern: %1", patternName(shape)), "—",
                       {Phrase::of("%1 % of the gap", displayText(100 * shape.share, 0)), shape.share}, ""));
  }

  void addOfModel(const GapStage& stage, double before) {
    rows.push_back(rowOf(stage.effect, Phrase::of("in the model"), shrinking(before, stage.rms), ""));
    std::vector<CauseParameter> numbers;
    for (const EffectEstimate& estimate : m_gap.evaluation->fit.effects)
      if (estimate.effect == stage.effect)
        numbers.push_back({estimate.name, estimate.value, estimate.sigma, estimate.unit});
    addSizes(numbers);
  }

  const Gap& m_gap;
  double m_coverage;
  std::vector<std::size_t> m_listedSteps = {};  ///< steps that a row already lists
};

/// The assumptions of the probabilities.
std::string probabilityNote(const Diagnosis& diagnosis) {
  std::vector<std::string> sizes;
  for (const Cause& cause : diagnosis.causes)
    if (const std::string size = plausibleSizeText(cause.effect); !size.empty())
      sizes.push_back(causeName(cause.effect) + " " + size);
  if (sizes.empty())
    return Phrase::of("Probabilities: given the catalogue and the plausible sizes of its effects.");
  //: %1: effects with their sizes, "collimation 30″, refraction 2″"
  return Phrase::of("Probabilities: given the catalogue and the plausible sizes of its effects (1σ: %1).",
                    listed(sizes));
}

}  // namespace

Statement gapCauses(const Gap& gap) {
  Statement statement{.id = "causes",
                      .title = Phrase::of("Causes"),
                      .columns = {{"cause", Phrase::of("Cause or form"), Role::Name},
                                  {"size", Phrase::of("size ± U")},
                                  {"probability", Phrase::of("probability")},
                                  {"shrinks", Phrase::of("change of the gap"), Role::Bar},
                                  {"look_alikes", Phrase::of("indistinguishable"), Role::Text}},
                      .rows = Rows(gap).rows};
  if (statement.rows.empty()) return statement;
  if (!gap.diagnosis->causes.empty()) statement.note = probabilityNote(*gap.diagnosis);
  if (gap.diagnosis->shape && gap.diagnosis->forms.empty())
    statement.sentences.push_back(
        Phrase::of("No effect of the catalogue makes this pattern, so nothing can be added to the model: "
                   "look for something of this shape in the set-up."));
  return statement;
}

Statement gapForms(const Gap& gap) {
  Statement statement{.id = "forms", .title = Phrase::of("Form of the gap"), .columns = {}, .rows = {}};
  const std::vector<FoundForm>& forms = gap.diagnosis->forms;
  if (forms.empty()) return statement;
  const auto add = [&](std::string sentence) {
    if (!sentence.empty()) statement.sentences.push_back(std::move(sentence));
  };
  for (const FoundForm& form : forms) {
    add(formSentence(form));
    add(cleanRangeSentence(form));
  }
  add(shrinkSentence(forms.front()));
  statement.note = Phrase::of("A form describes the readings; it does not name their cause.");
  return statement;
}

}  // namespace alidade
