#pragma once

#include <QDateTime>
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

/// Tells a file that was changed since from one that was not.
struct FileStamp {
  QDateTime changedAt = {};  ///< invalid without a file
  qint64 size = 0;

  bool operator==(const FileStamp&) const = default;
};

/// A session of a series, and whether it is usable.
struct SeriesSession {
  std::string path;  ///< encoded for the core
  std::optional<Epoch> epoch = {};
  std::string trouble = {};  ///< why the session has no epoch, or is left out
  FileStamp stamp = {};      ///< of the file when it was read
};

/// Sessions and their joint results.
struct Series {
  std::vector<SeriesSession> sessions;  ///< in the order added
  std::vector<DeviceHistory> devices;
};

using SharedSeries = std::shared_ptr<const Series>;

/// The paths of the sessions in folders, series and files, each once, encoded for the core. A folder yields
/// its *.alidade files by name. An unreadable series yields its own path.
std::vector<std::string> sessionPathsIn(const QStringList& filesAndFolders);

/// Was any file of the series changed or removed since it was read?
bool hasChangedFile(const Series& series);

/// Reads, fits and diagnoses the sessions of `added`, and the known ones whose files have changed, in
/// parallel, and evaluates their history together with the other known ones. After a stop request, unread
/// sessions are left out. Any thread may call `progressed`.
Series readSeries(std::vector<SeriesSession> known, const std::vector<std::string>& added,
                  const std::stop_token& stop,
                  const std::function<void(int done, int total)>& progressed = {});

/// Runs `readSeries` in the background.
class SeriesJob : public QObject {
  Q_OBJECT

 public:
  explicit SeriesJob(QObject* parent = nullptr);

  /// `known`: sessions read before. Call only while no work is running.
  void start(const SharedSeries& known, const std::vector<std::string>& added);
  void stop() { m_work.stop(); }
  bool isAtWork() const { return m_work.isAtWork(); }

 signals:
  void progressed(int done, int total);
  /// After a stop, `series` lacks the sessions that were still unread.
  void finished(const alidade::ui::SharedSeries& series);

 private:
  Background<Series> m_work;
};

}  // namespace alidade::ui
