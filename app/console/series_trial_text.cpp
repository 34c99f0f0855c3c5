#include "app/console/trial_text.h"

#include <nlohmann/json.hpp>

#include "app/console/text_layout.h"
#include "core/answers/json_text.h"
#include "core/base/number_text.h"
#include "core/simulation/trial_summary.h"
#include "core/wording/effect_name.h"

namespace alidade::console {

namespace {

using Json = nlohmann::ordered_json;

constexpr double clear = 6;  // a shared cause that shows by fewer σ in all sessions together is not scored

struct SeriesSummary {
  Tally named, first, owner, silent, alone, spoiled, spoilers, unknown, noiseOfAll;
};

SeriesSummary summaryOf(const std::vector<ScoredSeries>& series) {
  SeriesSummary summary;
  for (const ScoredSeries& one : series) {
    const bool isEmpty = one.seal.kind == "none";
    const bool isRight = isEmpty ? !one.isAlarm : one.isNamed;
    if (isEmpty) summary.silent.add(!one.isAlarm);
    summary.noiseOfAll.add(one.isNoiseOfAll);
    if (one.seal.spoiled) {
      summary.spoiled.add(isRight);
      summary.spoilers.add(one.isSpoilerFound);
    }
    if (isEmpty || (one.seal.visible && *one.seal.visible < clear)) continue;
    if (isOfNoCatalogue(one.seal.kind)) {
      summary.unknown.add(one.isNamed);
      continue;
    }
    summary.named.add(one.isNamed);
    summary.first.add(one.isFirst);
    summary.owner.add(one.isOwnerRight);
    summary.alone += {one.namedAlone, one.sessions};
  }
  return summary;
}

std::vector<std::string> scoreRow(const std::string& name, const Tally& tally) {
  const double share =
      100 * static_cast<double>(tally.hits) / static_cast<double>(std::max<std::size_t>(tally.count, 1));
  return {"  " + name, std::to_string(tally.hits) + "/" + std::to_string(tally.count),
          tally.count == 0 ? "-" : fixedText(share, 1) + " %"};
}

Json scoreJson(const Tally& tally) {
  return {{"hits", tally.hits}, {"count", tally.count}};
}

}  // namespace

std::string seriesTrialText(const std::vector<ScoredSeries>& series) {
  const SeriesSummary summary = summaryOf(series);
  std::string text =
      heading(std::to_string(series.size()) + " series") + "\n" +
      alignedColumns({scoreRow("named, or in its group", summary.named),
                      scoreRow("named first", summary.first), scoreRow("right owner", summary.owner),
                      scoreRow("named as uncatalogued", summary.unknown),
                      scoreRow("silent where nothing is shared", summary.silent),
                      scoreRow("right though a session is spoiled", summary.spoiled),
                      scoreRow("spoiled session named", summary.spoilers),
                      scoreRow("larger noise named for several sessions", summary.noiseOfAll),
                      scoreRow("named by a session alone", summary.alone)});
  for (const ScoredSeries& one : series)
    if (one.seal.kind == "none" ? one.isAlarm : !one.isNamed || !one.isOwnerRight)
      text += paragraph("  " + one.seal.id + " (" + one.seal.protocol + "): " + causeName(one.seal.kind) +
                            " of the " + std::string(nameOf(one.seal.owner)) +
                            (one.seal.visible ? ", " + fixedText(*one.seal.visible, 1) + " σ together" : "") +
                            (one.seal.spoiled ? ", spoiled by " + causeName(one.seal.spoiledBy) : "") +
                            ", taken for " + causeName(one.answer),
                        4);
  return text;
}

std::string seriesTrialJson(const std::vector<ScoredSeries>& series) {
  const SeriesSummary summary = summaryOf(series);
  Json list = Json::array();
  for (const ScoredSeries& one : series)
    list.push_back({{"id", one.seal.id},
                    {"kind", one.seal.kind},
                    {"shared", nameOf(one.seal.owner)},
                    {"protocol", one.seal.protocol},
                    {"visible_sigma_together", one.seal.visible ? Json(*one.seal.visible) : Json()},
                    {"spoiled_by", one.seal.spoiledBy},
                    {"answer", one.answer},
                    {"named", one.isNamed},
                    {"named_first", one.isFirst},
                    {"owner_right", one.isOwnerRight},
                    {"alarm", one.isAlarm},
                    {"sessions", one.sessions},
                    {"named_alone", one.namedAlone}});
  Json json = {{"count", series.size()},
               {"named", scoreJson(summary.named)},
               {"named_first", scoreJson(summary.first)},
               {"owner_right", scoreJson(summary.owner)},
               {"of_no_catalogue", scoreJson(summary.unknown)},
               {"noise_of_several", scoreJson(summary.noiseOfAll)},
               {"silent_where_empty", scoreJson(summary.silent)},
               {"right_though_spoiled", scoreJson(summary.spoiled)},
               {"spoiler_told", scoreJson(summary.spoilers)},
               {"named_alone", scoreJson(summary.alone)},
               {"series", list}};
  return answerText(std::move(json));
}

}  // namespace alidade::console
