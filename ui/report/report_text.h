#pragma once

#include <QCoreApplication>
#include <QStringList>

#include "core/wording/findings.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

/// The texts of the report, and how its phrases are joined.
struct Report {
  Q_DECLARE_TR_FUNCTIONS(Report)

 public:
  /// The clauses, joined by semicolons: "estimated along with the arcs; nothing was changed".
  static QString clauses(const QStringList& parts) {
    //: between clauses
    return parts.join(tr("; "));
  }
  /// The non-empty sentences, one after another.
  static QString sentences(QStringList parts) {
    parts.removeAll(QString());
    QString text;
    for (const QString& part : parts)
      text = text.isEmpty() ? part : qText(inTurn(text.toStdString(), part.toStdString()));
    return text;
  }
};

}  // namespace alidade::ui
