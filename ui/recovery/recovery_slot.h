#pragma once

#include <QLockFile>
#include <QString>
#include <memory>
#include <vector>

namespace alidade::ui {

/// The place of one window's record of unsaved changes, and of what is half typed beside it, held by a lock
/// file as long as this lives. The record outlives it: after a crash nobody holds the lock, and the next
/// start finds the record.
class RecoverySlot {
 public:
  enum class Kind {
    Session,  ///< a record of unsaved changes
    Drafts,   ///< what is typed into forms that no session holds
  };

  /// A fresh one. The folder is made where it is missing, and private.
  static std::unique_ptr<RecoverySlot> create(const QString& folder, Kind kind = Kind::Session);
  /// Those of the kind with a record that no living window holds, now held by the caller. In the order of
  /// their names.
  static std::vector<std::unique_ptr<RecoverySlot>> leftBehind(const QString& folder,
                                                               Kind kind = Kind::Session);

  QString path() const { return m_path; }  ///< of the record
  QString typedPath() const;               ///< of what is half typed
  void remove() const;                     ///< both; the place stays held

 private:
  explicit RecoverySlot(const QString& path);

  QString m_path;
  QLockFile m_lock;
};

}  // namespace alidade::ui
