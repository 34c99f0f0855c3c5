#include "core/wording/attainable.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/list_text.h"
#include "core/base/phrase.h"
#include "core/base/quantity_text.h"
#include "core/wording/effect_name.h"
#include "core/wording/measure.h"

namespace alidade {

namespace {

bool isEasier(const AttainableUncertainty& one, const AttainableUncertainty& other) {
  return std::pair(one.measures.size(), one.expanded) < std::pair(other.measures.size(), other.expanded);
}

/// Returns the two easiest entries and the one that reduces U most.
std::vector<AttainableUncertainty> fewOf(std::vector<AttainableUncertainty> list) {
  if (list.empty()) return list;
  const auto best = *std::ranges::min_element(list, {}, &AttainableUncertainty::expanded);
  std::ranges::stable_sort(list, isEasier);
  const auto isBest = [&](const AttainableUncertainty& one) {
    return one.measures == best.measures && one.known == best.known;
  };
  constexpr std::size_t cheap = 2;
  const bool isThere =
      std::any_of(list.begin(), list.begin() + std::min<std::ptrdiff_t>(cheap, std::ssize(list)), isBest);
  list.resize(std::min(cheap, list.size()));
  if (!isThere) list.push_back(best);
  return list;
}

}  // namespace

std::string attainableSentence(const std::vector<AttainableUncertainty>& attainable) {
  if (attainable.empty()) return "";
  const double least = std::ranges::min(attainable, {}, &AttainableUncertainty::expanded).expanded;
  const auto lengthText = [decimals = decimalsFor(least)](double expanded) {
    return displayText(expanded, decimals) + " mm";
  };
  std::vector<AttainableUncertainty> measured, known;
  for (auto one = attainable.begin() + 1; one != attainable.end(); ++one)
    (one->known.empty() ? measured : known).push_back(*one);
  std::string text = Phrase::of("Typical U for this plan: %1", lengthText(attainable.front().expanded));
  for (const std::vector<AttainableUncertainty>& list : {fewOf(measured), fewOf(known)}) {
    std::vector<std::string> texts;
    for (const AttainableUncertainty& one : list)
      texts.push_back(one.known.empty()
                          ? Phrase::of("%1 with %2", lengthText(one.expanded), textOf(one.measures))
                          : Phrase::of("%1 with %2 known", lengthText(one.expanded), causeName(one.known)));
    if (!texts.empty()) text = Phrase::of("%1; %2", text, listed(texts));
  }
  return Phrase::of("%1.", text);
}

const AttainableUncertainty* easiestMeasured(const std::vector<AttainableUncertainty>& attainable) {
  const AttainableUncertainty* easiest = nullptr;
  for (const AttainableUncertainty& one : attainable)
    if (!one.measures.empty() && (!easiest || isEasier(one, *easiest))) easiest = &one;
  return easiest;
}

}  // namespace alidade
