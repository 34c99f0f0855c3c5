#pragma once

#include <QObject>
#include <memory>
#include <string>

#include "core/guidance/outlook.h"
#include "ui/jobs/background.h"
#include "ui/jobs/gap_job.h"

namespace alidade::ui {

/// What more sightings bring to the session of one evaluation.
struct OutlookOfSession {
  SharedEvaluation evaluation;
  Outlook outlook;
  std::string failure = {};  ///< why there is none: sentences
};

using SharedOutlook = std::shared_ptr<const OutlookOfSession>;

/// Works out outlooks in the background, one at a time; the newest wins, and what a newer request has
/// overtaken is stopped and not delivered.
class OutlookJob : public QObject {
  Q_OBJECT

 public:
  explicit OutlookJob(QObject* parent = nullptr);

  /// Of an evaluation with a guide. `gap`: its diagnosis, or null.
  void request(SharedEvaluation evaluation, SharedGap gap);
  void cancel();  ///< nothing is delivered of what was requested
  bool isIdle() const { return !m_wanted && !m_work.isAtWork(); }

 signals:
  void found(const alidade::ui::SharedOutlook& outlook);

 private:
  void start();

  SharedEvaluation m_wanted;  ///< null where nothing is still to be begun
  SharedGap m_gap;
  bool m_isCancelled = false;
  Background<OutlookOfSession> m_work;
};

}  // namespace alidade::ui
