#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QThreadPool>
#include <memory>
#include <optional>
#include <stop_token>

#include "ui/jobs/evaluation.h"

namespace alidade::ui {

/// Views may keep it as long as they like.
using SharedEvaluation = std::shared_ptr<const Evaluation>;

/// Evaluates copies of the session in the background, in two stages: the fit at once, the readings that look
/// misread when they are found. While a fit is at work, only the newest request is kept; what a newer request
/// has overtaken is not delivered, and its search is stopped. A fit never waits for a search, and there is
/// one search at a time.
class FitJob : public QObject {
  Q_OBJECT

 public:
  explicit FitJob(QObject* parent = nullptr);
  ~FitJob() override;

  void request(const Session& session);
  bool isIdle() const { return !m_fitting && !m_fitted; }  ///< nothing is still to be delivered

 signals:
  /// Where it is not searched yet, `searched` follows unless another request comes first.
  void evaluated(const alidade::ui::SharedEvaluation& evaluation);
  /// The evaluation delivered last, now with its suspects.
  void searched(const alidade::ui::SharedEvaluation& evaluation);

 private:
  struct Search {
    SharedEvaluation fitted, found;
  };

  void fit(const Session& session);
  void finishFit();
  void search();
  void finishSearch();

  QThreadPool m_threads;
  QFutureWatcher<SharedEvaluation> m_fit;
  QFutureWatcher<Search> m_search;
  std::stop_source m_stop;  ///< of the search at work
  std::optional<Session> m_next;
  SharedEvaluation m_fitted;  ///< delivered last, its suspects still wanted; null where they are not
  bool m_fitting = false, m_searching = false;
};

}  // namespace alidade::ui
