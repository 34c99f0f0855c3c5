#pragma once

#include <QObject>
#include <memory>
#include <stop_token>

#include "core/evaluation/gap.h"
#include "core/simulation/blind_trial.h"
#include "core/simulation/trial_score.h"
#include "ui/jobs/background.h"

namespace alidade::ui {

/// A blind trial with its diagnosis and its score against the opened seal.
struct DiagnosedTrial {
  BlindTrial trial;
  Gap gap;
  TrialScore score;     ///< valid if there is a diagnosis
  std::string problem;  ///< why there is no trial or no diagnosis; empty if both exist
};

using SharedTrial = std::shared_ptr<const DiagnosedTrial>;

/// Runs in the calling thread. After a stop request, returns early without a diagnosis.
DiagnosedTrial diagnoseTrial(const BlindTrialOptions& options, std::uint64_t seed,
                             const std::stop_token& stop = {});

/// Draws and diagnoses trials in the background, in sequence: the seeds `seed`, `seed` + 1, …
class TrialJob : public QObject {
  Q_OBJECT

 public:
  explicit TrialJob(QObject* parent = nullptr);

  void start(const BlindTrialOptions& options, std::uint64_t seed, int count);
  void stop();  ///< no further trial is delivered
  bool isAtWork() const { return m_left > 0; }

 signals:
  void diagnosed(const alidade::ui::SharedTrial& trial);

 private:
  void next();
  void finish(const SharedTrial& trial);

  BlindTrialOptions m_options;
  std::uint64_t m_seed = 0;
  int m_left = 0;
  Background<DiagnosedTrial> m_work;
};

}  // namespace alidade::ui
