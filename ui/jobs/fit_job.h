#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "core/evaluation/evaluation.h"
#include "ui/jobs/background.h"
#include "ui/jobs/fit_request.h"

namespace alidade::ui {

using alidade::SharedEvaluation;

/// Evaluates copies of the session in the background, in two stages: first the fit, then the search for
/// misread readings. During a fit only the newest request is kept; outdated fits and searches are stopped and
/// not delivered. A fit never waits for a search, and only one search runs at a time.
class FitJob : public QObject {
  Q_OBJECT

 public:
  explicit FitJob(QObject* parent = nullptr);

  void request(const Session& session);
  /// The session requested before, after `change`: unchanged parts are not copied here.
  void request(const Session& session, const SessionChange& change);
  bool isFitting() const { return m_fit.isAtWork(); }
  bool isSearching() const { return m_fitted != nullptr; }
  /// Stops the search for misread readings; `searched` is not emitted for this evaluation.
  void stopSearch();
  bool isIdle() const { return !m_fit.isAtWork() && !m_fitted; }  ///< nothing remains to be delivered

 signals:
  /// Emitted with the fit; if suspects are not searched yet, `searched` follows unless another request comes
  /// first.
  void evaluated(const alidade::ui::SharedEvaluation& evaluation);
  /// The evaluation delivered last, now with its suspects.
  void searched(const alidade::ui::SharedEvaluation& evaluation);

 private:
  /// `found`: null if it was stopped.
  struct Search {
    SharedEvaluation fitted, found;
  };

  /// A discarded session, from which the next one is made without copying its rows.
  struct Spare {
    Session session;                            ///< the session before the last finished request
    std::shared_ptr<const FitRequest> onwards;  ///< that request
  };

  void begin();
  void fit(FitRequest request);
  void keepSpare(SharedEvaluation before);
  void finishFit(const SharedEvaluation& fitted);
  void search();
  void finishSearch(const Search& done);

  std::optional<FitRequest> m_next;
  std::shared_ptr<const FitRequest> m_request;  ///< running, or finished last
  std::optional<Spare> m_spare;
  SharedEvaluation m_last;    ///< of the last finished request, delivered or not; null: changes have no base
  SharedEvaluation m_fitted;  ///< delivered last, search still wanted; null if not
  Background<Evaluation> m_fit;
  Background<Search> m_search;
};

}  // namespace alidade::ui
