#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <string>

namespace alidade::ui {

class Dialogs;
class SessionDocument;

/// Asks where to, beginning with the path `suggested`, and writes `bytes` there, over none of the files that
/// were read for the window, or of `inputs`. The path; absent where nobody wants it, or it failed, which is
/// told.
std::optional<QString> writeWhereAsked(Dialogs& dialogs, const QString& title, const QString& suggested,
                                       const QString& suffix, const std::string& bytes,
                                       const QStringList& inputs = {});

/// Of the session's file; the home where it has none.
QString folderOf(const SessionDocument& document);

/// The same of what comes of a session: beside it, called `name` as far as a file can be.
std::optional<QString> writeBeside(const SessionDocument& document, Dialogs& dialogs, const QString& title,
                                   const QString& name, const QString& suffix, const std::string& bytes);

}  // namespace alidade::ui
