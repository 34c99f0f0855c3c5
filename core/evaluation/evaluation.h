#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/adjustment/gross_errors/suspects.h"
#include "core/adjustment/result/session_fit.h"
#include "core/adjustment/result/two_faces.h"
#include "core/base/failure.h"
#include "core/base/finding.h"
#include "core/evaluation/guide.h"
#include "core/evaluation/next_reading.h"
#include "core/session/measurement.h"
#include "core/session/session.h"

namespace alidade {

/// The contents of charts, which the window computes along with the evaluation. The core never reads them.
struct EvaluationPictures;

/// Everything computed from one copy of the session except its diagnosis. Charts, panels and report show the
/// same evaluation.
struct Evaluation {
  Session session;
  Examined examined;
  SessionFit fit;                                     ///< valid if `examined.measurement` is present
  PublishedSessionFit published;                      ///< valid if `examined.measurement` is present
  std::optional<TwoFaces> twoFaces;                   ///< absent unless visits were read in both faces
  std::vector<Suspect> suspects;                      ///< readings that look misread, the most certain first
  bool isSearched = true;                             ///< false: `suspects` and `journal` follow later
  std::string journal = {};                           ///< `journalSummary`; empty until `isSearched`
  std::optional<FailedWork> failure = {};             ///< why the fit failed although the entries allow one
  std::optional<FailedWork> searchFailure = {};       ///< why the search for suspects failed
  std::vector<std::optional<NextReading>> next = {};  ///< for each position
  std::shared_ptr<const Guide> guide = {};            ///< null if the session has no protocol
  std::shared_ptr<const EvaluationPictures> pictures = {};  ///< null if not computed
};

/// An evaluation that views share and may keep as long as they like.
using SharedEvaluation = std::shared_ptr<const Evaluation>;

/// The evaluation without suspects and journal summary: the search for suspects takes several times as long
/// as the fit. If asked to stop, returns early with fewer results.
Evaluation evaluateFit(Session session, const std::stop_token& stop = {});
/// The complete evaluation, including suspects and journal summary.
Evaluation withSuspects(Evaluation evaluation, const std::stop_token& stop = {});
/// A copy of `fitted` with suspects and journal summary; absent if asked to stop before the search ends.
std::optional<Evaluation> copyWithSuspects(const Evaluation& fitted, const std::stop_token& stop);
/// The evaluation after a failed fit: the session and the problems of its entries, without a fit.
Evaluation failedEvaluation(Session session, FailedWork failure);
/// The evaluation without suspects, after the search for suspects failed.
Evaluation withoutSuspects(Evaluation evaluation, FailedWork failure);
/// Runs `evaluateFit` and `withSuspects`.
Evaluation evaluate(Session session);

/// The findings of the fit, and why the fit or the search for suspects failed. Suspects are not included.
std::vector<Finding> findingsOf(const Evaluation& evaluation);

}  // namespace alidade
