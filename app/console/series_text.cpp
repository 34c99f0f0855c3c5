#include "app/console/series_text.h"

#include <algorithm>
#include <cmath>

#include "app/console/diagnosis_text.h"
#include "app/console/text_layout.h"
#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/effects/catalogue.h"
#include "core/session/own_effects.h"
#include "core/wording/effect_name.h"
#include "core/wording/series_words.h"
#include "core/wording/verdict.h"

namespace alidade::console {

namespace {

using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t mostRows = 200;  // rows of a table; --json has all

std::string sizesText(const std::vector<CauseParameter>& parameters) {
  std::vector<std::string> sizes;
  for (const CauseParameter& parameter : parameters) {
    const int decimals = decimalsFor(parameter.sigma, 0);
    sizes.push_back(parameterName(parameter.name) + " " + fixedText(parameter.value, decimals) +
                    (parameter.unit.size() > 1 ? " " + parameter.unit : "") + " (u " +
                    fixedText(parameter.sigma, decimals) + ")");
  }
  return listed(sizes);
}

std::string causeText(const SharedCause& cause, const SeriesDiagnosis& series) {
  std::string text = "\nCause: " + causeName(cause.cause.effect) + ", " + ownerText(cause) +
                     ", probability " + shortProbabilityText(cause.cause.probability) + "\n";
  if (!cause.cause.parameters.empty()) text += "  " + sizesText(cause.cause.parameters) + "\n";
  if (cause.visibleTogether > 0)
    text += "  shows by " + fixedText(cause.visibleInOne, 1) + " σ in a session, by " +
            fixedText(cause.visibleTogether, 1) + " σ in " + counted(cause.sessions.size(), "session") + "\n";
  else
    text += "  in " +
            (cause.sessions.size() == 1 ? series.sessions[cause.sessions.front()].name
                                        : counted(cause.sessions.size(), "session")) +
            "\n";
  if (cause.isDrifting || !cause.sizes.empty())
    for (const SizeInSession& size : cause.sizes) {
      text += "  " + series.sessions[size.session].name + ": " + sizesText(size.parameters) + "\n";
      if (&size - cause.sizes.data() + 1 == static_cast<std::ptrdiff_t>(mostRows)) break;
    }
  if (!cause.cause.indistinguishableFrom.empty())
    text += paragraph("  These sessions cannot distinguish it from: " +
                          causeNames(cause.cause.indistinguishableFrom, " or ") + ".",
                      2);
  return text;
}

std::string patternText(const SharedPattern& pattern) {
  std::string text = "\nPattern: " + pattern.follows;
  if (pattern.order > 0) text += ", " + std::to_string(pattern.order) + " periods in a turn";
  text += ", probability of no catalogue " + shortProbabilityText(pattern.probability) + "\n";
  if (pattern.visibleTogether > 0)
    text += "  shows by " + fixedText(pattern.visibleInOne, 1) + " σ in a session, by " +
            fixedText(pattern.visibleTogether, 1) + " σ in " + counted(pattern.sessions.size(), "session") +
            "\n";
  return text;
}

std::string causesOf(const std::vector<Cause>& causes) {
  std::vector<std::string> names;
  for (const Cause& cause : causes) names.push_back(causeName(cause.effect));
  return names.empty() ? "" : " (" + listed(names) + ")";
}

std::string sessionsText(const SeriesDiagnosis& series) {
  Rows rows{{"  session", "date", "instrument", "guideway", "alone", "within the series"}};
  for (const SeriesMember& member : series.sessions) {
    if (rows.size() > mostRows) break;
    rows.push_back({"  " + member.name, member.measuredOn, member.instrument, member.guideway,
                    std::string(nameOf(member.alone)) + causesOf(member.causesAlone),
                    std::string(nameOf(member.diagnosis.verdict)) + causesOf(member.diagnosis.causes)});
  }
  std::string text = "\nSessions\n" + alignedColumns(rows);
  if (series.sessions.size() > mostRows)
    text += "  and " + std::to_string(series.sessions.size() - mostRows) + " more; --json has all\n";
  return text;
}

std::string whereText(const SeriesDiagnosis& series) {
  std::string text = "\nWhere the gap lies\n";
  for (auto first = series.where.begin(); first != series.where.end();) {
    const auto end =
        std::find_if(first, series.where.end(), [&](const GapShare& share) { return share.by != first->by; });
    std::vector<std::string> parts;
    for (auto share = first; share != end; ++share)
      if (share->share >= 0.01 && parts.size() < mostRows)
        parts.push_back(share->of + ": " + fixedText(100 * share->share, 0) + " %");
    if (!parts.empty() && end - first > 1) text += paragraph("  by " + first->by + " – " + listed(parts), 4);
    first = end;
  }
  return text;
}

std::string gapText(const SeriesDiagnosis& series) {
  const auto row = [](const std::string& name, const GapSize& size) {
    return std::vector<std::string>{
        name, fixedText(size.rms, 2),
        std::isnan(size.reducedChiSquare) ? "none" : fixedText(size.reducedChiSquare, 3)};
  };
  std::string text = "\n" + alignedColumns({{"", "rms (″)", "reduced χ²"},
                                            row("fit only", series.gap),
                                            row("with what is shared", series.after)});
  if ((!series.causes.empty() || series.pattern) && !std::isnan(series.shrink.heldOut))
    text += "Sessions held out shrink by " + fixedText(100 * series.shrink.heldOut, 1) + " %.\n";
  return text;
}

std::string adviceText(const SeriesDiagnosis& series) {
  if (series.advice.empty()) return "";
  std::string text = "\nWhat to measure next\n";
  for (const SeriesAdvice& advice : series.advice) text += paragraph("  " + sentenceOf(advice), 4);
  return text;
}

std::string undetectableText(const SeriesDiagnosis& series) {
  if (series.undetectable.empty()) return "";
  Rows rows{{"  effect", "moves Δd by (mm)", "trace (σ)"}};
  for (const UndetectableEffect& effect : series.undetectable)
    rows.push_back(
        {"  " + causeName(effect.effect), fixedText(effect.influence, 4), fixedText(effect.visibleSigma, 1)});
  return "\nUnseen by all sessions together: what a plausible size of these would do\n" +
         alignedColumns(rows);
}

}  // namespace

std::string seriesText(const std::string& name, const SeriesDiagnosis& series) {
  std::string text = heading(name) + "\nVerdict: " + std::string(nameOf(series.verdict)) + "\n" +
                     paragraph(sentenceOf(series)) + gapText(series);
  if (series.pattern) text += patternText(*series.pattern);
  for (const SharedCause& cause : series.causes) text += causeText(cause, series);
  for (const OfferedEffect& offered : series.offered)
    text += formsText({offered.form}) + "  in " + counted(offered.sessions.size(), "session") +
            "; --keep-form keeps it as " + ownId(offered.effect) + "\n";
  if (!series.causes.empty() || series.pattern) text += whereText(series);
  return text + sessionsText(series) + adviceText(series) + undetectableText(series) +
         findingsText(findingsOf(series));
}

}  // namespace alidade::console
