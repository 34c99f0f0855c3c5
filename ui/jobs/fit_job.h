#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "ui/jobs/background.h"
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

  void request(const Session& session);
  bool isIdle() const { return !m_fit.isAtWork() && !m_fitted; }  ///< nothing is still to be delivered

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
  void finishFit(const SharedEvaluation& fitted);
  void search();
  void finishSearch(const Search& done);

  std::optional<Session> m_next;
  SharedEvaluation m_fitted;  ///< delivered last, its suspects still wanted; null where they are not
  Background<Evaluation> m_fit;
  Background<Search> m_search;
};

}  // namespace alidade::ui
