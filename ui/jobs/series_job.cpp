#include "ui/jobs/series_job.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <atomic>
#include <set>

#include "core/base/failure.h"
#include "core/base/phrase.h"
#include "core/base/threads.h"
#include "core/series/history/history_sentences.h"
#include "core/series/history/series_file.h"
#include "core/wording/series_words.h"
#include "ui/document/encoded_path.h"
#include "ui/jobs/failed_job.h"

namespace alidade::ui {

namespace {

QFileInfo fileAt(const std::string& path) {
  return QFileInfo(QFile::decodeName(QByteArray::fromStdString(path)));
}

FileStamp stampOf(const std::string& path) {
  const QFileInfo file = fileAt(path);
  return {file.lastModified(), file.size()};
}

bool isRead(const SeriesSession& session) {
  return session.epoch || !session.trouble.empty();
}

bool isChanged(const SeriesSession& session) {
  return !session.path.empty() && stampOf(session.path) != session.stamp;
}

SeriesSession loaded(const std::string& path) {
  SeriesSession session{.path = path, .stamp = stampOf(path)};
  if (const QFileInfo file = fileAt(path); file.exists() && !file.isFile()) {
    session.trouble = Phrase::of("is a pipe or a device: choose a file");
    return session;
  }
  const auto failure = failureOf([&] {
    Result<Epoch> epoch = loadEpoch(path);
    if (epoch)
      session.epoch = *std::move(epoch);
    else
      session.trouble = epoch.problem().text();
  });
  if (failure) session.trouble = *failure;
  return session;
}

/// Computes the histories of the usable sessions, and says why other sessions are left out.
void addHistories(Series& series) {
  std::vector<Epoch> epochs;
  std::vector<std::size_t> sessions;
  for (SeriesSession& session : series.sessions)
    if (session.epoch) session.trouble.clear();
  for (std::size_t i = 0; i < series.sessions.size(); ++i)
    if (series.sessions[i].epoch) {
      epochs.push_back(*series.sessions[i].epoch);
      sessions.push_back(i);
    }
  DeviceHistories histories = deviceHistories(epochs);
  for (const std::size_t undated : histories.undated)
    series.sessions[sessions[undated]].trouble =
        Phrase::of("it has no date and is not used: enter the day of the measurement");
  for (const auto& [copy, first] : histories.copies)
    series.sessions[sessions[copy]].trouble = copyReason(epochs[copy].file, epochs[first].file);
  series.devices = std::move(histories.devices);
}

}  // namespace

std::vector<std::string> sessionPathsIn(const QStringList& filesAndFolders) {
  std::vector<std::string> paths;
  std::set<QString> seen;
  const auto add = [&](const QFileInfo& file) {
    const QString real = file.canonicalFilePath();
    if (seen.insert(real.isEmpty() ? file.absoluteFilePath() : real).second)
      paths.push_back(encodedPath(file.absoluteFilePath()));
  };
  for (const QString& path : filesAndFolders) {
    const QFileInfo info(path);
    if (isSeriesPath(encodedPath(path)) && !info.isDir())
      if (const auto series = loadSeriesFile(encodedPath(path))) {
        for (const std::string& session : series->sessions)
          add(QFileInfo(QFile::decodeName(QByteArray::fromStdString(session))));
        continue;
      }
    if (!info.isDir()) {
      add(info);
      continue;
    }
    const QDir folder(path, QStringLiteral("*.alidade"), QDir::Name, QDir::Files);
    for (const QFileInfo& file : folder.entryInfoList()) add(file);
  }
  return paths;
}

SeriesJob::SeriesJob(QObject* parent)
    : QObject(parent), m_work([this](const SharedSeries& series) { emit finished(series); }) {}

bool hasChangedFile(const Series& series) {
  return std::ranges::any_of(series.sessions, isChanged);
}

Series readSeries(std::vector<SeriesSession> known, const std::vector<std::string>& added,
                  const std::stop_token& stop, const std::function<void(int done, int total)>& progressed) {
  Series series{std::move(known), {}};
  for (const std::string& path : added) series.sessions.push_back({path});
  std::vector<SeriesSession*> unread;
  for (SeriesSession& session : series.sessions)
    if (!isRead(session) || isChanged(session)) unread.push_back(&session);
  std::atomic<int> done = 0;
  doEach(threadsOrAll(0), unread.size(), [&](std::size_t i) {
    if (stop.stop_requested()) return;
    *unread[i] = loaded(unread[i]->path);
    if (progressed) progressed(++done, static_cast<int>(unread.size()));
  });
  std::erase_if(series.sessions, [](const SeriesSession& session) { return !isRead(session); });
  addHistories(series);
  return series;
}

void SeriesJob::start(const SharedSeries& known, const std::vector<std::string>& added) {
  m_work.start(
      [this, known, added](const std::stop_token& stop) {
        return readSeries(known ? known->sessions : std::vector<SeriesSession>(), added, stop,
                          [this](int done, int total) { emit progressed(done, total); });
      },
      [known](const std::string& reason) {
        Series series = known ? *known : Series();
        series.sessions.push_back(
            {{}, {}, reportFailure({PHRASE_LATER("Phrase", "series"), reason, std::nullopt, {}})});
        return series;
      });
}

}  // namespace alidade::ui
