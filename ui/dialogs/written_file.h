#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <string>

namespace alidade::ui {

class Dialogs;
class SessionDocument;

/// Asks for a path, starting with `suggested`, and writes `bytes` to this path. Refuses files read for the
/// window and files in `inputs`. Reports a failure. Returns the path; absent if cancelled or failed.
std::optional<QString> writeToChosenPath(Dialogs& dialogs, const QString& title, const QString& suggested,
                                         const QString& suffix, const std::string& bytes,
                                         const QStringList& inputs = {});

/// The folder of the session's file; the home folder if it has none.
QString folderOf(const SessionDocument& document);

/// Asks for a path and writes output of a session. Suggests the session's folder and `name`, without
/// characters that file names cannot have.
std::optional<QString> writeForSession(const SessionDocument& document, Dialogs& dialogs,
                                       const QString& title, const QString& name, const QString& suffix,
                                       const std::string& bytes);

}  // namespace alidade::ui
