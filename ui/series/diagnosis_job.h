#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "ui/jobs/background.h"
#include "ui/series/diagnosis_panel.h"

namespace alidade::ui {

/// The result of diagnosing sessions together.
struct SeriesAnswer {
  std::vector<std::string> files;        ///< of the diagnosed sessions, indexed by `SeriesMember::file`
  SharedSeriesDiagnosis diagnosis = {};  ///< null if there is none
  std::string reason = {};               ///< the reason for a missing diagnosis
};

/// Reads session files and diagnoses the usable ones together.
SeriesAnswer diagnoseTogether(const std::vector<std::string>& files, const std::stop_token& stop,
                              const std::function<void(int done, int total)>& progressed = {});

/// Runs `diagnoseTogether` in the background.
class SeriesDiagnosisJob : public QObject {
  Q_OBJECT

 public:
  explicit SeriesDiagnosisJob(QObject* parent = nullptr);

  /// Stops running work, then starts with these files.
  void start(const std::vector<std::string>& files);
  bool isAtWork() const { return m_work.isAtWork(); }

 signals:
  void progressed(int done, int total);
  void finished(const std::shared_ptr<const alidade::ui::SeriesAnswer>& answer);

 private:
  Background<SeriesAnswer> m_work;
  std::optional<std::vector<std::string>> m_next;

  void begin(const std::vector<std::string>& files);
};

}  // namespace alidade::ui
