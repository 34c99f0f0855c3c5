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

/// A session of a series, as far as it can be used.
struct SeriesSession {
  std::string path;  ///< as the core takes it
  std::optional<Epoch> epoch = {};
  std::string trouble = {};  ///< why there is no epoch, or why it takes no part
};

/// Sessions, and what they say together.
struct Series {
  std::vector<SeriesSession> sessions;  ///< in the order they were added
  std::vector<DeviceHistory> devices;
};

using SharedSeries = std::shared_ptr<const Series>;

/// The sessions of folders and files, each once, as paths of the core: a folder's *.alidade by name.
std::vector<std::string> sessionPathsIn(const QStringList& filesAndFolders);

/// Reads, fits and diagnoses the sessions of `added`, in parallel, and tells the history of these and of
/// those known. Asked to stop, it leaves out those that were still to be read. `progressed`: from any thread.
Series readSeries(std::vector<SeriesSession> known, const std::vector<std::string>& added,
                  const std::stop_token& stop,
                  const std::function<void(int done, int total)>& progressed = {});

/// Reads, fits and diagnoses the sessions that are new, in the background and in parallel, and tells the
/// history of all of them.
class SeriesJob : public QObject {
  Q_OBJECT

 public:
  explicit SeriesJob(QObject* parent = nullptr);

  /// `known`: sessions that were read before and stay. Only while nothing is at work.
  void start(const SharedSeries& known, const std::vector<std::string>& added);
  void stop() { m_work.stop(); }
  bool isAtWork() const { return m_work.isAtWork(); }

 signals:
  void progressed(int done, int total);
  /// Without those that were still to be read when it was stopped.
  void told(const alidade::ui::SharedSeries& series);

 private:
  Background<Series> m_work;
};

}  // namespace alidade::ui
