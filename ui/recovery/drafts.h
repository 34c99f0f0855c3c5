#pragma once

#include <QJsonObject>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "core/base/problem.h"
#include "ui/jobs/background.h"
#include "ui/recovery/recovery_slot.h"

namespace alidade::ui {

/// What is typed into forms that no session holds (rows of an instrument check, a protocol, the pointing
/// zeros of an import), each form's under its name, until it is handed in or given up. A form says it at each
/// key; it is written behind the keys, on a thread of its own, a quarter of a second after the first that is
/// not written yet. What an ended process left behind is there again.
class Drafts : public QObject {
  Q_OBJECT

 public:
  Drafts();
  ~Drafts() override;

  /// From now on in `folder`, which is made where it is missing, and private. Before that, and for an empty
  /// one, nothing is kept.
  void keepIn(const QString& folder);
  bool isKept() const { return m_slot != nullptr; }

  /// Empty where nothing is kept of the form.
  QJsonObject of(const QString& form) const { return m_all.value(form).toObject(); }
  /// Takes the place of what was kept of the form; empty: nothing is.
  void set(const QString& form, const QJsonObject& draft);

  /// Writes what is not written yet and waits for it: the process is about to end.
  void keepNow();

 signals:
  /// Drafts cannot be written, and why; empty: they can again.
  void troubled(const QString& sentence);

 private:
  using Written = std::optional<Problem>;

  void adoptLeftBehind(const QString& folder);
  void startWriter();
  void schedule();
  void keep();
  static Written write(const QString& path, const QJsonObject& all);
  void finishWriting(const Written& problem);

  QJsonObject m_all;
  std::unique_ptr<RecoverySlot> m_slot;
  QTimer m_timer;
  bool m_isDue = false;  ///< something is newer than what is being written
  QString m_trouble;     ///< as told
  std::unique_ptr<Background<Written>> m_writing;
};

/// Those of this process.
Drafts& drafts();

}  // namespace alidade::ui
