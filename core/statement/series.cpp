#include "core/statement/series.h"

#include <cmath>
#include <string>
#include <utility>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/base/visible_text.h"
#include "core/effects/catalogue.h"
#include "core/wording/diagnosis_sentence.h"
#include "core/wording/effect_name.h"
#include "core/wording/series_words.h"
#include "core/wording/size_text.h"
#include "core/wording/verdict.h"

namespace alidade {

namespace {

using Role = Statement::Column::Role;
using Row = Statement::Row;

/// "tilt about x: 12.0″ (u 1.5)"; without the name if the effect's name contains it.
std::string sizesText(const std::string& effect, const std::vector<CauseParameter>& parameters) {
  std::vector<std::string> sizes;
  for (const CauseParameter& parameter : parameters) {
    const std::string size = sizeWithStandard(parameter.value, parameter.sigma, parameter.unit);
    sizes.push_back(isNamedBy(effect, parameter.name)
                        ? size
                        //: a number of an effect and its size: "tilt about x: 12.0″ (u 1.5)"
                        : Phrase::of("%1: %2", parameterName(parameter.name), size));
  }
  return listed(sizes);
}

std::string traceText(double sigmas) {
  return sigmas > 0 ? displayText(sigmas, 1) : "—";
}

/// The session that alone has the cause, else the owner.
std::string ownerOf(const SharedCause& cause, const SeriesDiagnosis& series) {
  const bool isOfOne = cause.owner == CauseOwner::Time && cause.sessions.size() == 1;
  return isOfOne ? series.sessions[cause.sessions.front()].name : ownerText(cause);
}

void addCause(Statement& statement, const SharedCause& cause, const SeriesDiagnosis& series) {
  const std::string& effect = cause.cause.effect;
  const std::string size = cause.cause.parameters.empty() && !cause.sizes.empty()
                               ? Phrase::of("its own in each session")
                               : sizesText(effect, cause.cause.parameters);
  statement.rows.push_back(
      {.cells = {causeTitle(effect), visibleText(ownerOf(cause, series)),
                 cause.isDrifting ? Phrase::of("%1, changing between sessions", size) : size,
                 std::to_string(cause.sessions.size()), shortProbabilityText(cause.cause.probability),
                 traceText(cause.visibleInOne), traceText(cause.visibleTogether),
                 causeNames(cause.cause.indistinguishableFrom, Phrase::of(" or "))},
       .id = effect});
  for (const SizeInSession& own : cause.sizes)
    statement.rows.push_back({.cells = {visibleText(series.sessions[own.session].name), "",
                                        sizesText(effect, own.parameters), "", "", "", "", ""},
                              .isPart = true});
}

void addPattern(Statement& statement, const SharedPattern& pattern) {
  statement.rows.push_back(
      {.cells = {Phrase::of("Pattern: %1", visibleText(patternText(pattern))), "", "",
                 std::to_string(pattern.sessions.size()), shortProbabilityText(pattern.probability),
                 traceText(pattern.visibleInOne), traceText(pattern.visibleTogether), ""}});
}

/// The verdict of a session by itself in a few words: "One cause: collimation".
std::string headlineOf(DiagnosisVerdict verdict, const std::vector<Cause>& causes) {
  Diagnosis diagnosis;
  diagnosis.verdict = verdict;
  diagnosis.causes = causes;
  return alidade::headlineOf(diagnosis);
}

Row rowOfResiduals(std::string name, const GapSize& size) {
  return {.cells = {std::move(name), displayText(size.rms, 2), displayText(size.reducedChiSquare, 2)}};
}

}  // namespace

Statement seriesCauses(const SeriesDiagnosis& series) {
  Statement statement{.id = "series_causes",
                      .title = Phrase::of("What the sessions share"),
                      .columns = {{"cause", Phrase::of("Cause"), Role::Name},
                                  {"owner", Phrase::of("Belongs to"), Role::Word},
                                  {"size", Phrase::of("Size"), Role::Word},
                                  {"sessions", Phrase::of("Sessions")},
                                  {"probability", Phrase::of("Probability")},
                                  {"in_one", Phrase::of("In one session (σ)")},
                                  {"in_all", Phrase::of("In all (σ)")},
                                  {"look_alikes", Phrase::of("indistinguishable"), Role::Text}},
                      .rows = {}};
  for (const SharedCause& cause : series.causes) addCause(statement, cause, series);
  if (series.pattern) addPattern(statement, *series.pattern);
  return statement;
}

Statement seriesStages(const SeriesDiagnosis& series) {
  Statement statement{.id = "series_stages",
                      .title = Phrase::of("Before and after"),
                      .columns = {{"stage", Phrase::of("Model"), Role::Name},
                                  {"rms", Phrase::of("rms ″")},
                                  {"reduced_chi2", "χ²/f"}},
                      .rows = {rowOfResiduals(Phrase::of("fit only"), series.gap),
                               rowOfResiduals(Phrase::of("with what is shared"), series.after)}};
  if ((!series.causes.empty() || series.pattern) && !std::isnan(series.shrink.heldOut))
    statement.sentences = {Phrase::of("The residuals of sessions held out of the fit shrink by %1 %.",
                                      displayText(100 * series.shrink.heldOut, 1))};
  return statement;
}

Statement seriesSessions(const SeriesDiagnosis& series) {
  Statement statement{.id = "series_sessions",
                      .title = Phrase::of("Each session alone and within the series"),
                      .columns = {{"session", Phrase::of("Session"), Role::Name},
                                  {"date", Phrase::of("Date"), Role::Word},
                                  {"instrument", Phrase::of("Instrument"), Role::Word},
                                  {"guideway", Phrase::of("Device"), Role::Word},
                                  {"alone", Phrase::of("Alone"), Role::Word},
                                  {"within", Phrase::of("Within the series"), Role::Word}},
                      .rows = {}};
  for (const SeriesMember& member : series.sessions)
    statement.rows.push_back(
        {.cells = {visibleText(member.name), visibleText(member.measuredOn), visibleText(member.instrument),
                   visibleText(member.guideway), headlineOf(member.alone, member.causesAlone),
                   alidade::headlineOf(member.diagnosis)},
         .id = std::to_string(member.file)});
  return statement;
}

Statement seriesAdvice(const SeriesDiagnosis& series) {
  Statement statement{
      .id = "series_advice", .title = Phrase::of("What to measure next"), .columns = {}, .rows = {}};
  for (const SeriesAdvice& advice : series.advice) statement.sentences.push_back(sentenceOf(advice));
  return statement;
}

}  // namespace alidade
