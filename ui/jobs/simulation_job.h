#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "core/adjustment/monte_carlo/monte_carlo.h"
#include "ui/jobs/background.h"
#include "ui/jobs/fit_job.h"

namespace alidade::ui {

/// They differ in nothing that enters a fit.
bool measuresAlike(const Session& one, const Session& other);

/// The uncertainty of one evaluation checked by propagating distributions.
struct BudgetCheck {
  SharedEvaluation evaluation;
  std::optional<MonteCarlo>
      simulated;             ///< empty: it was stopped, or too few draws gave a result, or it failed
  std::string failure = {};  ///< why it failed: sentences

  /// The figures are those of this session too.
  bool isOf(const Session& session) const;
};

using SharedBudgetCheck = std::shared_ptr<const BudgetCheck>;

/// Checks one evaluation at a time in the background.
class SimulationJob : public QObject {
  Q_OBJECT

 public:
  explicit SimulationJob(QObject* parent = nullptr);

  /// Does nothing while one is at work. No `draws`: as many as it takes to tell.
  void start(const SharedEvaluation& evaluation, std::size_t draws);
  void stop() { m_work.stop(); }  ///< `finished` follows, with what there is: nothing
  bool isAtWork() const { return m_work.isAtWork(); }
  std::size_t drawsMade() const { return m_made; }

 signals:
  void finished(const alidade::ui::SharedBudgetCheck& check);

 private:
  std::atomic<std::size_t> m_made = 0;
  Background<BudgetCheck> m_work;
};

}  // namespace alidade::ui
