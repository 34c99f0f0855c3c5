#include "ui/dialogs/import_notes.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

#include "ui/text/effect_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr qsizetype mostNotes = 12;

struct ImportNotesText {
  Q_DECLARE_TR_FUNCTIONS(ImportNotes)
};

QString sentence(const QString& text) {
  return capitalised(text) + QLatin1Char('.');
}

}  // namespace

bool isReadingsFile(const QString& path) {
  const QStringList suffixes = {QStringLiteral("gsi"), QStringLiteral("csv"), QStringLiteral("tsv"),
                                QStringLiteral("txt")};
  return suffixes.contains(QFileInfo(path).suffix(), Qt::CaseInsensitive);
}

QString importNotes(const Import& import) {
  QStringList notes;
  for (const LineProblem& problem : import.problems) notes.append(sentence(visibleLine(problem.text())));
  for (const std::string& remark : import.remarks) notes.append(sentence(visibleLine(remark)));
  if (notes.isEmpty()) return {};
  const qsizetype more = notes.size() - mostNotes;
  if (more > 0) {
    notes = notes.mid(0, mostNotes);
    notes.append(ImportNotesText::tr("And %1 more.").arg(more));
  }
  return notes.join(QLatin1Char('\n'));
}

}  // namespace alidade::ui
