#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "ui/jobs/background.h"
#include "ui/jobs/evaluation.h"
#include "ui/jobs/fit_request.h"

namespace alidade::ui {

/// Views may keep it as long as they like.
using SharedEvaluation = std::shared_ptr<const Evaluation>;

/// Evaluates copies of the session in the background, in two stages: the fit at once, the readings that look
/// misread when they are found. While a fit is at work, only the newest request is kept; what a newer request
/// has overtaken is stopped and not delivered, and so is its search. A fit never waits for a search, and
/// there is one search at a time.
class FitJob : public QObject {
  Q_OBJECT

 public:
  explicit FitJob(QObject* parent = nullptr);

  void request(const Session& session);
  /// The session requested before, as `change` has left it: what did not change is not copied here.
  void request(const Session& session, const SessionChange& change);
  bool isFitting() const { return m_fit.isAtWork(); }
  bool isSearching() const { return m_fitted != nullptr; }
  /// Looks for misread readings no further; `searched` does not come for this evaluation.
  void stopSearch();
  bool isIdle() const { return !m_fit.isAtWork() && !m_fitted; }  ///< nothing is still to be delivered

 signals:
  /// Where it is not searched yet, `searched` follows unless another request comes first.
  void evaluated(const alidade::ui::SharedEvaluation& evaluation);
  /// The evaluation delivered last, now with its suspects.
  void searched(const alidade::ui::SharedEvaluation& evaluation);

 private:
  /// `found`: null where it was stopped.
  struct Search {
    SharedEvaluation fitted, found;
  };

  /// A session that is of no more use where it stood: to be made the next one without a copy of its rows.
  struct Spare {
    Session session;                            ///< as before the request done last
    std::shared_ptr<const FitRequest> onwards;  ///< that request
  };

  void begin();
  void fit(FitRequest request);
  void keepSpare(SharedEvaluation before);
  void finishFit(const SharedEvaluation& fitted);
  void search();
  void finishSearch(const Search& done);

  std::optional<FitRequest> m_next;
  std::shared_ptr<const FitRequest> m_request;  ///< at work, or done last
  std::optional<Spare> m_spare;
  SharedEvaluation m_last;    ///< of the request done last, delivered or not; null: changes have no ground
  SharedEvaluation m_fitted;  ///< delivered last, its suspects still wanted; null where they are not
  Background<Evaluation> m_fit;
  Background<Search> m_search;
};

}  // namespace alidade::ui
