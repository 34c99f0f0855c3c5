#pragma once

#include <QObject>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/series/history/device_history.h"
#include "ui/jobs/background.h"

namespace alidade::ui {

/// A session of a series, and whether it is usable.
struct SeriesSession {
  std::string path;  ///< in the form of the core
  std::optional<Epoch> epoch = {};
  std::string trouble = {};  ///< why there is no epoch, or why it is left out
};

/// Sessions and their joint results.
struct Series {
  std::vector<SeriesSession> sessions;  ///< in the order added
  std::vector<DeviceHistory> devices;
};

using SharedSeries = std::shared_ptr<const Series>;

/// The sessions of folders, series and files, each once, as paths of the core: a folder's *.alidade files by
/// name. An unreadable series is listed itself.
std::vector<std::string> sessionPathsIn(const QStringList& filesAndFolders);

/// Reads, fits and diagnoses the sessions of `added` in parallel, and evaluates their history together with
/// the known ones. Asked to stop, it leaves out the unread ones. `progressed` may be called from any thread.
Series readSeries(std::vector<SeriesSession> known, const std::vector<std::string>& added,
                  const std::stop_token& stop,
                  const std::function<void(int done, int total)>& progressed = {});

/// Reads, fits and diagnoses new sessions in the background and in parallel, and evaluates the history of
/// all.
class SeriesJob : public QObject {
  Q_OBJECT

 public:
  explicit SeriesJob(QObject* parent = nullptr);

  /// `known`: sessions read before. Only while nothing is running.
  void start(const SharedSeries& known, const std::vector<std::string>& added);
  void stop() { m_work.stop(); }
  bool isAtWork() const { return m_work.isAtWork(); }

 signals:
  void progressed(int done, int total);
  /// Lacks the sessions still unread when it was stopped.
  void finished(const alidade::ui::SharedSeries& series);

 private:
  Background<Series> m_work;
};

}  // namespace alidade::ui
