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

/// True if the fit has equal input in both sessions.
bool measuresAlike(const Session& one, const Session& other);

/// A Monte Carlo check of the uncertainty of one evaluation.
struct BudgetCheck {
  SharedEvaluation evaluation;
  std::optional<MonteCarlo> simulated;  ///< empty: stopped, failed, or too few draws gave a result
  std::string failure = {};             ///< sentences that say why the check failed

  /// True if the result is valid for `session`, too: the fit has the same input.
  bool isOf(const Session& session) const;
};

using SharedBudgetCheck = std::shared_ptr<const BudgetCheck>;

/// Checks one evaluation at a time in the background.
class SimulationJob : public QObject {
  Q_OBJECT

 public:
  explicit SimulationJob(QObject* parent = nullptr);

  /// Does nothing while a check is running. `draws` 0: as many as the comparison with the budget needs.
  void start(const SharedEvaluation& evaluation, std::size_t draws);
  void stop() { m_work.stop(); }  ///< `finished` follows without a result
  bool isAtWork() const { return m_work.isAtWork(); }
  std::size_t drawsMade() const { return m_made; }

 signals:
  void finished(const alidade::ui::SharedBudgetCheck& check);

 private:
  std::atomic<std::size_t> m_made = 0;
  Background<BudgetCheck> m_work;
};

}  // namespace alidade::ui
