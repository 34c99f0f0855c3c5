#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <string>

#include "core/guidance/outlook.h"
#include "core/guidance/sighting_choice.h"
#include "ui/jobs/background.h"
#include "ui/jobs/gap_job.h"

namespace alidade::ui {

/// The U of Δd that further sightings reach in the session of one evaluation.
struct OutlookOfSession {
  SharedEvaluation evaluation;
  Outlook outlook = {};                      ///< unless the protocol is by worth (`isByWorth`)
  std::optional<SightingsAhead> ahead = {};  ///< if the protocol is by worth
  std::string failure = {};                  ///< sentences that say why there is no outlook
};

using SharedOutlook = std::shared_ptr<const OutlookOfSession>;

/// Computes outlooks in the background, one at a time. Only the newest request is delivered; outdated ones
/// are stopped.
class OutlookJob : public QObject {
  Q_OBJECT

 public:
  explicit OutlookJob(QObject* parent = nullptr);

  /// Requests the outlook of an evaluation with a guide. `gap`: the diagnosis, or null; `uncertainty`: the U
  /// of Δd that a protocol by worth is to reach, mm.
  void request(SharedEvaluation evaluation, SharedGap gap, double uncertainty);
  void cancel();  ///< drops the request; nothing more is delivered
  bool isIdle() const { return !m_wanted && !m_work.isAtWork(); }

 signals:
  void found(const alidade::ui::SharedOutlook& outlook);

 private:
  void start();

  SharedEvaluation m_wanted;  ///< null if nothing waits to start
  SharedGap m_gap;
  double m_uncertainty = 0;
  bool m_isCancelled = false;
  Background<OutlookOfSession> m_work;
};

}  // namespace alidade::ui
