#pragma once

#include <compare>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/joint/joint_fit.h"
#include "core/base/result.h"
#include "core/diagnosis/visibility.h"
#include "core/simulation/truth.h"

namespace alidade {

/// One reading that was read or written down wrongly.
struct GrossErrorCell {
  int axisDeg = 0, round = 1, point = 1, face = 1;
  ReadingKind circle = ReadingKind::Horizontal;
  int time = 1;  ///< the how many-th position at this axis

  auto operator<=>(const GrossErrorCell&) const = default;
};

/// What has to be known of a session to score its diagnosis. Kept from the diagnosis until it is done.
struct SealedTruth {
  std::string id = {};
  std::string kind = {};                 ///< the only cause; or none, two_causes, several_causes, unknown_…
  std::vector<std::string> causes = {};  ///< ids of what was put in
  std::string protocol = {};             ///< plan of readings, as it was called
  double intersection = 0;               ///< true Δd, mm
  std::optional<double> visible = {};    ///< of the one effect of the catalogue, σ of the readings
  std::vector<std::string> lookAlikes = {};      ///< ids that these readings do not tell from it
  std::vector<GrossErrorCell> grossErrors = {};  ///< in order
};

/// Put in on purpose, though no catalogue holds it: whatever the diagnosis has no name for.
bool isOfNoCatalogue(const std::string& kind);

/// Of a truth file: the truth of a series of sessions, which has a Δd for each of them.
bool isTruthOfSeries(const nlohmann::json& entry);

/// `visibility` of the truth's only effect, where there is one.
SealedTruth sealed(const std::string& id, const Truth& truth, const std::optional<Visibility>& visibility);

/// The truth file of a set of trials: a JSON object {id: {kind, intersection_mm, protocol, causes, blunders:
/// [[position, round, point, face, horizontal, vertical], …] with positions by `NumberedPosition`,
/// visible_sigma, look_alikes: [[id, cosine, σ], …]}, …}; kind and intersection_mm are required, other keys
/// are passed over, `plan` stands for protocol, and of `all` the keys of `there` are the causes. A kind that
/// the diagnosis has no name for is one of no catalogue. Truths of series are passed over. In the order of
/// the ids. Fails, with the id and the key, on what could not be scored: a value of the wrong type, a kind
/// that is an effect but for two letters, a cause that no answer can name, a gross_error without blunders,
/// two_causes without causes; and where there is no truth.
Result<std::vector<SealedTruth>> readSealedTruths(const std::string& text);

}  // namespace alidade
