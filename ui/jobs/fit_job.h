#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <memory>
#include <optional>

#include "ui/jobs/evaluation.h"

namespace alidade::ui {

/// Views may keep it as long as they like.
using SharedEvaluation = std::shared_ptr<const Evaluation>;

/// Evaluates copies of the session in the background. While one is at work, only the newest request is kept;
/// an evaluation that a newer request has overtaken is not delivered.
class FitJob : public QObject {
  Q_OBJECT

 public:
  explicit FitJob(QObject* parent = nullptr);
  ~FitJob() override;

  void request(const Session& session);
  bool isIdle() const { return !m_running; }

 signals:
  void evaluated(const alidade::ui::SharedEvaluation& evaluation);

 private:
  void start(const Session& session);
  void finish();

  QFutureWatcher<SharedEvaluation> m_watcher;
  std::optional<Session> m_next;
  bool m_running = false;
};

}  // namespace alidade::ui
