#pragma once

#include <QLockFile>
#include <QString>
#include <memory>
#include <vector>

namespace alidade::ui {

/// The files of one window for unsaved changes and unfinished entries, reserved by a lock file for the
/// lifetime of this object. The destructor keeps the record; a crash frees the lock, so that the next start
/// finds the record.
class RecoverySlot {
 public:
  enum class Kind {
    Session,  ///< a record of unsaved changes
    Drafts,   ///< typing in forms outside any session
  };

  /// A new slot. Creates the folder as private if missing.
  static std::unique_ptr<RecoverySlot> create(const QString& folder, Kind kind = Kind::Session);
  /// Locks and returns the slots of this kind that have a record but no running process, ordered by name.
  static std::vector<std::unique_ptr<RecoverySlot>> leftBehind(const QString& folder,
                                                               Kind kind = Kind::Session);

  QString path() const { return m_path; }  ///< path of the record
  QString typedPath() const;               ///< path of the unfinished entries
  void remove() const;                     ///< removes both files; the slot stays locked

 private:
  explicit RecoverySlot(const QString& path);

  QString m_path;
  QLockFile m_lock;
};

}  // namespace alidade::ui
