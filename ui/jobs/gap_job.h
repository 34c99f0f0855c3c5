#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "ui/jobs/background.h"
#include "ui/jobs/gap.h"

namespace alidade::ui {

/// Views may keep it as long as they like.
using SharedGap = std::shared_ptr<const Gap>;

/// Diagnoses evaluations in the background, one at a time; the newest wins, and what a newer request has
/// overtaken is stopped and not delivered. At once while somebody watches, otherwise when the session has
/// come to rest.
class GapJob : public QObject {
  Q_OBJECT

 public:
  static constexpr int restMilliseconds = 500;

  explicit GapJob(QObject* parent = nullptr);

  void request(SharedEvaluation evaluation);
  /// Forgets what was requested: the session has changed.
  void cancel();
  void setWatched(bool watched);
  /// From the next request on the causes are weighed with the reference, or no longer. Off at first.
  void setWithReference(bool withReference);
  bool isIdle() const { return !m_wanted; }  ///< nothing is still to be delivered
  bool isAtWork() const { return m_work.isAtWork(); }

 signals:
  void assessed(const alidade::ui::SharedGap& gap);

 private:
  void start();
  void finish(const SharedGap& gap);

  QTimer m_rest;
  SharedEvaluation m_wanted;  ///< null where nothing is
  bool m_isWatched = false;
  bool m_isWithReference = false;
  Background<Gap> m_work;
};

}  // namespace alidade::ui
