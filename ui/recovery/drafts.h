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

/// Unfinished typing in forms outside any session (rows of an instrument check, a protocol, the pointing
/// zeros of an import), stored per form name until the form is accepted or cancelled.
/// A form reports each keystroke; a separate thread writes the drafts 0.25 s after the first unwritten
/// keystroke. Drafts of a terminated process are restored.
class Drafts : public QObject {
  Q_OBJECT

 public:
  Drafts();
  ~Drafts() override;

  /// Stores drafts in `folder` from now on, creating it as private if missing. Before the first call, or with
  /// an empty folder name, nothing is stored.
  void keepIn(const QString& folder);
  bool isKept() const { return m_slot != nullptr; }

  /// Empty if nothing is stored for the form.
  QJsonObject of(const QString& form) const { return m_all.value(form).toObject(); }
  /// Replaces the draft of the form; empty: removes it.
  void set(const QString& form, const QJsonObject& draft);

  /// Writes pending drafts and waits for the end of writing; called before the process ends.
  void keepNow();

 signals:
  /// Reports why drafts cannot be written; empty: they can be written again.
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
  bool m_isDue = false;  ///< newer data wait for the end of the running write
  QString m_trouble;     ///< the sentence last reported
  std::unique_ptr<Background<Written>> m_writing;
};

/// The drafts of this process.
Drafts& drafts();

}  // namespace alidade::ui
