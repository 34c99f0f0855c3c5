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

/// One reading that was misread or mistyped.
struct GrossErrorCell {
  int axisDeg = 0, round = 1, point = 1, face = 1;
  ReadingKind circle = ReadingKind::Horizontal;
  int repeat = 1;  ///< the repeat at this axis

  auto operator<=>(const GrossErrorCell&) const = default;
};

/// The information on a session by which its diagnosis is scored. The diagnosis must not see it.
struct SealedTruth {
  std::string id = {};
  std::string kind = {};                 ///< the only cause; or none, two_causes, several_causes, unknown_…
  std::vector<std::string> causes = {};  ///< ids of the simulated causes
  bool statesOwn = false;                ///< the session states those causes that are the user's own effects
  std::string protocol = {};             ///< name of the plan of readings
  double intersection = 0;               ///< true Δd, mm
  std::optional<double> visible = {};    ///< visibility of the only effect, σ of the readings
  std::vector<std::string> lookAlikes = {};      ///< ids indistinguishable from the only effect
  std::vector<GrossErrorCell> grossErrors = {};  ///< sorted
};

/// True if the kind is uncatalogued: the diagnosis cannot name it.
bool isOfNoCatalogue(const std::string& kind);

/// True if an entry of a truth file describes a series of sessions, with a Δd for each session.
bool isTruthOfSeries(const nlohmann::json& entry);

/// Seals a truth. `visibility`: the visibility of its only effect; absent if it has several or none.
SealedTruth sealed(const std::string& id, const Truth& truth, const std::optional<Visibility>& visibility);

/// The truth file of a set of trials: a JSON object {id: {kind, intersection_mm, protocol, causes, blunders:
/// [[position, round, point, face, horizontal, vertical], …] with positions by `NumberedPosition`,
/// visible_sigma, look_alikes: [[id, cosine, σ], …]}, …}. `kind` and `intersection_mm` are required; unknown
/// keys are ignored. `plan` is a synonym of `protocol`. For the kind `all`, the keys of `there` are the
/// causes. A kind that the diagnosis cannot name is uncatalogued. Truths of series are skipped. The result is
/// in the order of the ids. Fails if there is no truth. Fails, with the id and the key, on a value of the
/// wrong type, an effect misspelt by one or two letters as kind, a cause that cannot be diagnosed, a
/// gross_error without blunders, and two_causes without causes.
Result<std::vector<SealedTruth>> readSealedTruths(const std::string& text);

}  // namespace alidade
