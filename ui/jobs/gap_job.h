#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "core/evaluation/gap.h"
#include "ui/jobs/background.h"

namespace alidade::ui {

using SharedGap = std::shared_ptr<const Gap>;

/// Diagnoses evaluations in the background, one at a time. Only the newest request is delivered; outdated
/// ones are stopped. Starts at once while the page of the gap is in front, otherwise `restMilliseconds` after
/// the last request. Later delivers the gap again with the rows on which its verdict depends.
class GapJob : public QObject {
  Q_OBJECT

 public:
  static constexpr int restMilliseconds = 500;

  explicit GapJob(QObject* parent = nullptr);

  void request(SharedEvaluation evaluation);
  /// Drops the request, since the session has changed.
  void cancel();
  void setWatched(bool watched);
  /// Sets whether later requests include the reference as evidence for the causes. Off at first. Returns
  /// false if it is so already.
  bool setWithReference(bool withReference);
  bool isIdle() const { return !m_wanted; }  ///< nothing remains to be delivered
  bool isAtWork() const { return m_work.isAtWork(); }

 signals:
  void assessed(const alidade::ui::SharedGap& gap);
  void completed(const alidade::ui::SharedGap& gap);  ///< the same gap with its `dependences`

 private:
  void start();
  void finish(const SharedGap& gap);
  void complete();
  void dropCompletion();

  QTimer m_rest;
  SharedEvaluation m_wanted;  ///< null if nothing is requested
  bool m_isWatched = false;
  bool m_isWithReference = false;
  SharedGap m_incomplete;  ///< delivered gap whose `dependences` are still to be sought; null: none
  Background<Gap> m_work, m_completion;
};

}  // namespace alidade::ui
