#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "ui/jobs/background.h"
#include "ui/series/diagnosis_panel.h"

namespace alidade::ui {

/// What a diagnosis of sessions together came to.
struct SeriesAnswer {
  std::vector<std::string> files;        ///< of the sessions diagnosed, as `SeriesMember::file` counts them
  SharedSeriesDiagnosis diagnosis = {};  ///< null where there is none
  std::string reason = {};               ///< then: why
};

/// Reads the sessions of files and diagnoses them together; those that cannot be used are left out.
SeriesAnswer diagnoseTogether(const std::vector<std::string>& files, const std::stop_token& stop,
                              const std::function<void(int done, int total)>& progressed = {});

/// The same in the background.
class SeriesDiagnosisJob : public QObject {
  Q_OBJECT

 public:
  explicit SeriesDiagnosisJob(QObject* parent = nullptr);

  /// While something is at work it is stopped, and this follows.
  void start(const std::vector<std::string>& files);
  bool isAtWork() const { return m_work.isAtWork(); }

 signals:
  void progressed(int done, int total);
  void told(const std::shared_ptr<const alidade::ui::SeriesAnswer>& answer);

 private:
  Background<SeriesAnswer> m_work;
  std::optional<std::vector<std::string>> m_next;

  void begin(const std::vector<std::string>& files);
};

}  // namespace alidade::ui
