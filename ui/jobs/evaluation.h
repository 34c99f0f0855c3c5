#pragma once

#include <optional>
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
};

/// All but the suspects, whose search takes several times as long.
Evaluation evaluateFit(Session session);
/// The same with the suspects, and with the finding that names them.
Evaluation withSuspects(Evaluation evaluation, const std::stop_token& stop = {});
/// Both in one.
Evaluation evaluate(Session session);

}  // namespace alidade::ui
