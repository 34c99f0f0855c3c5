#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "core/evaluation/evaluation.h"
#include "ui/jobs/background.h"

namespace alidade::ui {

using alidade::SharedEvaluation;

/// Evaluates copies of the session in the background, in two stages: first the fit, then the search for
/// misread readings. During a fit only the newest request is kept; outdated fits and searches are stopped and
/// not delivered. A fit never waits for a search, and only one search runs at a time.
class FitJob : public QObject {
  Q_OBJECT

 public:
  explicit FitJob(QObject* parent = nullptr);

  void request(Session session);
  bool isFitting() const { return m_fit.isAtWork(); }
  bool isSearching() const { return m_fitted != nullptr; }
  /// Stops the search for misread readings; `searched` is not emitted for this evaluation.
  void stopSearch();
  bool isIdle() const { return !m_fit.isAtWork() && !m_fitted; }  ///< nothing remains to be delivered

 signals:
  /// Emitted after the fit. `searched` follows if a search for misread readings is needed; `request` and
  /// `stopSearch` cancel it.
  void evaluated(const alidade::ui::SharedEvaluation& evaluation);
  /// The evaluation delivered last, now with the result of the search for misread readings.
  void searched(const alidade::ui::SharedEvaluation& evaluation);

 private:
  /// `found` is null if the search was stopped.
  struct Search {
    SharedEvaluation fitted, found;
  };

  void fit(Session session);
  void finishFit(const SharedEvaluation& fitted);
  void search();
  void finishSearch(const Search& done);

  std::optional<Session> m_next;  ///< requested during a fit
  SharedEvaluation m_fitted;      ///< delivered last, and still to be searched; else null
  Background<Evaluation> m_fit;
  Background<Search> m_search;
};

}  // namespace alidade::ui
