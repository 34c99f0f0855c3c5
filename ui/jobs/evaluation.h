#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/adjustment/session_fit.h"
#include "core/adjustment/suspects.h"
#include "core/adjustment/two_faces.h"
#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade::ui {

/// Everything computed from one copy of the session. A plain value that charts, panels and the report show
/// alike.
struct Evaluation {
  Session session;
  Examined examined;
  SessionFit fit;                    ///< as made where `examined.measurement` is absent
  PublishedSessionFit published;     ///< likewise
  std::optional<TwoFaces> twoFaces;  ///< where visits were read in both faces
  std::vector<Suspect> suspects;     ///< readings that look misread, the most certain first
  bool isSearched = true;            ///< false: `suspects` are still to be found
  std::string failure = {};          ///< why there is no fit although there could be one: sentences
};

/// All but the suspects, whose search takes several times as long.
Evaluation evaluateFit(Session session);
/// The same with the suspects, and with the finding that names them.
Evaluation withSuspects(Evaluation evaluation, const std::stop_token& stop = {});
/// In place of a fit that broke down: the session and what is wrong with its entries, nothing fitted;
/// `failure` is said in a finding, too.
Evaluation failedEvaluation(Session session, const std::string& failure);
/// The fit without the suspects, whose search broke down; a finding says so.
Evaluation withoutSuspects(Evaluation evaluation, const std::string& failure);
/// Both in one.
Evaluation evaluate(Session session);

}  // namespace alidade::ui
