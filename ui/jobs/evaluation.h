#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/result/session_fit.h"
#include "core/adjustment/result/two_faces.h"
#include "core/session/measurement.h"
#include "core/session/session.h"
#include "ui/jobs/guide.h"
#include "ui/jobs/next_reading.h"

namespace alidade::ui {

struct ArcPicture;
struct ResidualPicture;

/// Everything computed from one copy of the session. A plain value that charts, panels and the report show
/// alike.
struct Evaluation {
  Session session;
  Examined examined;
  SessionFit fit;                    ///< as made where `examined.measurement` is absent
  PublishedSessionFit published;     ///< likewise; of very many rows still to come until `isSearched`
  std::optional<TwoFaces> twoFaces;  ///< where visits were read in both faces
  std::vector<Suspect> suspects;     ///< readings that look misread, the most certain first
  bool isSearched = true;            ///< false: `suspects` and `journal` are still to come
  std::string journal = {};          ///< `journalSummary`, which may have to write the session
  std::string failure = {};          ///< why there is no fit although there could be one: sentences
  std::string searchFailure = {};    ///< why the search for suspects came to nothing: sentences
  std::vector<std::optional<NextReading>> next = {};  ///< of each position
  std::shared_ptr<const Guide> guide = {};            ///< null where the session follows no protocol
  /// What the charts show of it, worked out where the fit was; null in an evaluation put together by hand.
  std::shared_ptr<const ArcPicture> arcs = {};
  std::shared_ptr<const ResidualPicture> residuals = {};
};

/// Is the published method still to come?
bool isPublishedToCome(const Evaluation& evaluation);

/// All but the suspects, whose search takes several times as long, the summary of the journal, and with very
/// many rows the published method. Asked to stop, it returns early with less.
Evaluation evaluateFit(Session session, const std::stop_token& stop = {});
/// The same with them.
Evaluation withSuspects(Evaluation evaluation, const std::stop_token& stop = {});
/// A copy of it with them, which is made once they are found: nothing where it was asked to stop before.
std::optional<Evaluation> copyWithSuspects(const Evaluation& fitted, const std::stop_token& stop);
/// In place of a fit that broke down: the session and what is wrong with its entries, nothing fitted.
Evaluation failedEvaluation(Session session, const std::string& failure);
/// The fit without the suspects, whose search broke down.
Evaluation withoutSuspects(Evaluation evaluation, const std::string& failure);
/// Both in one.
Evaluation evaluate(Session session);

}  // namespace alidade::ui
