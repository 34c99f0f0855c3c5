#include "core/wording/guidance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/list_text.h"
#include "core/base/number_text.h"
#include "core/base/phrase.h"
#include "core/observation/reading_ref.h"
#include "core/session/face.h"
#include "core/wording/position_name.h"

namespace alidade {

namespace {

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) {
    if (sentence.empty()) continue;
    if (!text.empty())
      text = Phrase::of("%1 %2", text, sentence);
    else
      text = sentence;
  }
  return text;
}

std::string deviationText(const SightingsToRepeat& toRepeat) {
  if (std::isnan(toRepeat.size)) return "";
  const std::string sign = toRepeat.size < 0 ? "" : "+";
  return sign + displayText(toRepeat.size, 1) + "″";
}

std::string circleName(const SightingsToRepeat& toRepeat) {
  return inWords(toRepeat.kind.value_or(ReadingKind::Horizontal));
}

/// Selects from each pair U of Δd, measured, or U of Δd, fit only.
struct UncertaintyChoice {
  bool isMeasured = false;

  double of(const ExpandedPair& pair) const {
    return isMeasured ? pair.asMeasured.value_or(pair.ofFit) : pair.ofFit;
  }
};

/// Selects U of Δd, measured, if the outlook has it; otherwise U of Δd, fit only.
UncertaintyChoice uncertaintyChoice(const Outlook& outlook) {
  const ExpandedPair* any = outlook.now             ? &*outlook.now
                            : outlook.ahead.empty() ? nullptr
                                                    : &outlook.ahead.front().expanded;
  return {any && any->asMeasured.has_value()};
}

/// Formats the lengths of one sentence with the same number of decimals.
class Lengths {
 public:
  explicit Lengths(const Outlook& outlook, UncertaintyChoice choice) {
    double least = INFINITY;
    const auto see = [&](const ExpandedPair& pair) { least = std::min(least, choice.of(pair)); };
    if (outlook.now) see(*outlook.now);
    for (const RoundsAhead& ahead : outlook.ahead) see(ahead.expanded);
    m_decimals = decimalsFor(least);
  }
  std::string operator()(double length) const { return displayText(length, m_decimals); }

 private:
  int m_decimals = 2;
};

std::string moreRounds(int rounds) {
  if (rounds == 1) return Phrase::of("One more round");
  if (rounds == 2) return Phrase::of("Two more rounds");
  if (rounds == 3) return Phrase::of("Three more rounds");
  return Phrase::of("%1 more rounds", rounds);
}

/// The effect of the remaining protocol and of more rounds, if no verdict requires a certain U.
std::string withoutNeed(const Outlook& outlook, const ProtocolProgress& progress, UncertaintyChoice choice,
                        const Lengths& text) {
  std::vector<std::string> sentences;
  const double planned = choice.of(outlook.ahead.front().expanded);
  if (!progress.isComplete())
    sentences.push_back(outlook.now
                            ? Phrase::of("The rest of the protocol brings U from %1 to %2 mm.",
                                         text(choice.of(*outlook.now)), text(planned))
                            : Phrase::of("At its end, the protocol reaches U = %1 mm.", text(planned)));
  for (const RoundsAhead& ahead : outlook.ahead)
    if (ahead.rounds > 0 && text(choice.of(ahead.expanded)) != text(planned))
      sentences.push_back(Phrase::of("%1 would bring U to %2 mm.", moreRounds(ahead.rounds),
                                     text(choice.of(ahead.expanded))));
  return joined(sentences);
}

std::string limitSentence(const Outlook& outlook, UncertaintyChoice choice, const Lengths& text) {
  if (!outlook.limit) return "";
  return Phrase::of("Further rounds do not reduce %1 mm of U: that part is the same in each round.",
                    text(choice.of(*outlook.limit)));
}

/// States that even the largest number of rounds in the outlook leaves U too large.
std::string notEnough(const Outlook& outlook, UncertaintyChoice choice, const Lengths& text) {
  const RoundsAhead& most = outlook.ahead.back();
  const std::string needed = text(choice.of(*outlook.needed));
  if (outlook.limit && !outlook.isEnough(*outlook.limit))
    return Phrase::of("More rounds are not enough: U always stays above %1 mm, and the verdict needs %2 mm.",
                      text(choice.of(*outlook.limit)), needed);
  return Phrase::of("Even %1 more rounds leave U at %2 mm; the verdict needs %3 mm.", most.rounds,
                    text(choice.of(most.expanded)), needed);
}

std::string verdictName(bool isWithin) {
  return isWithin ? Phrase::of("within the tolerance") : Phrase::of("beyond the tolerance");
}

std::string whetherEnough(const Outlook& outlook, const ProtocolProgress& progress, UncertaintyChoice choice,
                          const Lengths& text) {
  if (outlook.isTorn)
    return Phrase::of(
        "Δd, fit only, and Δd, measured, are on different sides of the tolerance: look at the gap before you "
        "sight more.");
  const std::string needed = text(choice.of(*outlook.needed));
  const auto from = outlook.now ? std::optional(choice.of(*outlook.now)) : std::nullopt;
  if (outlook.now && outlook.isEnough(*outlook.now))
    return Phrase::of("The readings are enough: U = %1 mm, and the verdict “%2” needs %3 mm.", text(*from),
                      verdictName(outlook.isWithin), needed);
  const auto rounds = outlook.roundsNeeded();
  if (!rounds) return notEnough(outlook, choice, text);
  const auto enough = std::ranges::find(outlook.ahead, *rounds, &RoundsAhead::rounds);
  const std::string to = text(choice.of(enough->expanded)), start = text(from.value_or(NAN));
  if (*rounds == 0)
    return Phrase::of("The rest of the protocol brings U from %1 to %2 mm; the verdict needs %3 mm.", start,
                      to, needed);
  const bool isComplete = progress.isComplete();
  if (*rounds == 1)
    return isComplete
               ? Phrase::of("One more round brings U from %1 to %2 mm; the verdict needs %3 mm.", start, to,
                            needed)
               : Phrase::of(
                     "One round beyond the protocol brings U from %1 to %2 mm; the verdict needs %3 mm.",
                     start, to, needed);
  return isComplete ? Phrase::of("%1 bring U from %2 to %3 mm; the verdict needs %4 mm.", moreRounds(*rounds),
                                 start, to, needed)
                    : Phrase::of("%1 beyond the protocol bring U from %2 to %3 mm; the verdict needs %4 mm.",
                                 moreRounds(*rounds), start, to, needed);
}

}  // namespace

std::string sightingName(const PlannedSighting& planned) {
  if (planned.isZero) {
    if (planned.isAfter)
      return planned.face == 1 ? Phrase::of("pointing zero after the readings")
                               : Phrase::of("pointing zero after the readings, face 2");
    return planned.face == 1 ? Phrase::of("pointing zero") : Phrase::of("pointing zero, face 2");
  }
  std::vector<std::string> parts{Phrase::of("point %1", planned.point)};
  if (planned.round != 1) parts.push_back(Phrase::of("round %1", planned.round));
  if (planned.face != 1) parts.push_back(faceName(planned.face));
  return listed(parts);
}

std::string sightingNameInSession(const PlannedSighting& planned) {
  return Phrase::of("%1: %2", positionName(planned.axisDeg, planned.repeat), sightingName(planned));
}

std::string stateName(SightingState state) {
  switch (state) {
    case SightingState::Taken:
      return Phrase::of("taken");
    case SightingState::Next:
      return Phrase::of("next");
    case SightingState::Missed:
      return Phrase::of("skipped");
    case SightingState::Left:
      return Phrase::of("to come");
    case SightingState::Excluded:
      return Phrase::of("excluded");
  }
  return "";
}

std::string progressSentences(const ProtocolProgress& progress) {
  std::vector<std::string> sentences{
      Phrase::of("%1 of %2 sightings are taken.", progress.taken, progress.sightings.size())};
  const auto addCount = [&](std::size_t count, const char* one, const char* several) {
    if (count > 0) sentences.push_back(count == 1 ? Phrase::of(one) : Phrase::of(several, count));
  };
  addCount(progress.missed, PHRASE_LATER("Phrase", "One was skipped."),
           PHRASE_LATER("Phrase", "%1 were skipped."));
  addCount(progress.excluded, PHRASE_LATER("Phrase", "One is excluded."),
           PHRASE_LATER("Phrase", "%1 are excluded."));
  addCount(progress.outOfTurn, PHRASE_LATER("Phrase", "One was taken out of order."),
           PHRASE_LATER("Phrase", "%1 were taken out of order."));
  if (progress.unplanned > 0) sentences.push_back(unplannedSentence(progress));
  return joined(sentences);
}

std::string unplannedSentence(const ProtocolProgress& progress) {
  if (progress.unplanned == 0) return "";
  return progress.unplanned == 1 ? Phrase::of("One reading is not in the protocol.")
                                 : Phrase::of("%1 readings are not in the protocol.", progress.unplanned);
}

std::string repeatSentence(const SightingsToRepeat& toRepeat, const ProtocolProgress& progress) {
  const PlannedSighting& first = progress.sightings[toRepeat.sightings.front()].planned;
  const std::string where = sightingNameInSession(first), size = deviationText(toRepeat),
                    sigmas = displayText(toRepeat.sigmas, 1);
  switch (toRepeat.reason) {
    case SightingsToRepeat::Reason::Misread:
      if (size.empty()) return Phrase::of("%1 again: the value typed can hardly be a reading.", where);
      return Phrase::of("%1 again: its %2 reading disagrees with the others by %3.", where,
                        circleName(toRepeat), size);
    case SightingsToRepeat::Reason::FacesDisagree:
      return Phrase::of(
          "%1 again in both faces: the difference of the faces on the %2 circle departs from the others by "
          "%3 (%4 σ).",
          where, circleName(toRepeat), size, sigmas);
    case SightingsToRepeat::Reason::WaysDisagree:
      return Phrase::of("%1 again, and in round %2: in that round the place lies %3 farther out (%4 σ).",
                        where, progress.sightings[toRepeat.sightings.back()].planned.round, size, sigmas);
    case SightingsToRepeat::Reason::ZeroMoved:
      return Phrase::of(
          "%1 again: its %2 reading differs from the earlier one by %3 (%4 σ). If the new reading differs "
          "too, the instrument has moved: sight the whole position again.",
          where, circleName(toRepeat), size, sigmas);
  }
  return "";
}

std::string repeatsFirst(const std::vector<SightingsToRepeat>& allToRepeat) {
  const bool isAny = std::ranges::find(allToRepeat, SightingsToRepeat::Reason::Misread,
                                       &SightingsToRepeat::reason) != allToRepeat.end();
  return isAny ? Phrase::of("First repeat the sightings that look misread: they make U too large.") : "";
}

std::string outlookSentences(const Outlook& outlook, const ProtocolProgress& progress) {
  if (outlook.ahead.empty())
    return Phrase::of(
        "Once a pointing zero is read and the protocol has both positions, the rounds still needed are shown "
        "here.");
  const UncertaintyChoice choice = uncertaintyChoice(outlook);
  const Lengths text(outlook, choice);
  std::vector<std::string> sentences;
  if (outlook.needed) {
    sentences.push_back(whetherEnough(outlook, progress, choice, text));
  } else {
    sentences.push_back(withoutNeed(outlook, progress, choice, text));
    sentences.push_back(limitSentence(outlook, choice, text));
  }
  const RoundsAhead& planned = outlook.ahead.front();
  if (choice.isMeasured) {
    const Lengths own(outlook, {false});
    sentences.push_back(
        outlook.now ? Phrase::of("U of Δd, fit only, is %1 mm now and %2 mm at the end of the protocol.",
                                 own(outlook.now->ofFit), own(planned.expanded.ofFit))
                    : Phrase::of("U of Δd, fit only, is %1 mm at the end of the protocol.",
                                 own(planned.expanded.ofFit)));
  }
  return joined(sentences);
}

}  // namespace alidade
